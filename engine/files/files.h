#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/input_error.h"

/// Reads and writes whole files. The programs open no file elsewhere.
namespace oblong {

/// An error in a file or its contents: `FILE: WHERE: what is wrong, what was expected`.
class FileError : public std::runtime_error {
  public:
    FileError(const std::string& path, const std::string& where, const std::string& what_is_wrong)
        : std::runtime_error(path + ": " + where + ": " + what_is_wrong) {}
};

inline constexpr std::size_t kLargestFile_bytes = std::size_t{1} << 30;

/// Whose a file is.
enum class FileUse : std::uint8_t {
    Named,  ///< a user names it: a device or a pipe is read and written to, as by any program
    Kept    ///< the program keeps it for the player: a regular file, or refused; what was written outlasts a power cut
};

/// All bytes of a file. Throws FileError where it can't be read or has more than `most_bytes`.
std::vector<std::uint8_t> read_file(const std::string& path, std::size_t most_bytes = kLargestFile_bytes,
                                    FileUse use = FileUse::Named);
/// `length` bytes of a file from an offset on. Throws FileError where they can't be read or are not there.
std::vector<std::uint8_t> read_file_part(const std::string& path, std::uint64_t offset, std::size_t length);
/// A whole file as text.
std::string read_text(const std::string& path);

/// Where a path leads at the end of its symbolic links; there need be nothing. Throws FileError where they go round.
std::string end_of_links(const std::string& path);

/// Writes a whole file under a name that no other program has, beside the end of the path's links, and renames it when
/// it is complete: whatever fails, a full disk or the power too, the file that was there stays. Throws FileError.
void write_file(const std::string& path, std::span<const std::uint8_t> bytes, FileUse use = FileUse::Named);
void write_file(const std::string& path, const std::string& text, FileUse use = FileUse::Named);
inline constexpr const char* kUnfinishedExtension = ".part";  ///< of such a name

/// The same for a regular file that is kept (no link), and is kept on under another name, in the place of what was
/// there before. Whenever the program ends: `path` or, where it is missing, `former_path` is a whole file.
void replace_file(const std::string& path, const std::string& former_path, std::span<const std::uint8_t> bytes);

/// Removes files, those that there are, so that they are gone after a power cut too. Throws FileError.
void remove_files(const std::vector<std::string>& paths);

/// Flushes standard output. Throws FileError if any output, now or before, could not be written.
void flush_standard_output();

/// Whether a path leads to something below a folder, by its text alone: it is relative, not empty, and has no "..".
bool stays_below(const std::string& path);

/// Makes a folder and those above it, unless they are there, to outlast a power cut. Throws FileError.
void make_folder(const std::string& path);

/// Runs work(); an InputError that it throws becomes a FileError with the file's name.
template <class Work>
auto naming_file(const std::string& path, Work work) {
    try {
        return work();
    } catch (const InputError& error) {
        throw FileError(path, error.where, error.what());
    }
}

/// parse(all bytes of a file); an InputError becomes a FileError with the file's name. Throws FileError.
template <class Parse>
auto read_parsed(const std::string& path, Parse parse) {
    const std::vector<std::uint8_t> bytes = read_file(path);
    return naming_file(path, [&] { return parse(std::span<const std::uint8_t>(bytes)); });
}

}  // namespace oblong

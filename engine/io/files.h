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

/// The use of a file that is written.
enum class FileUse : std::uint8_t {
    Named,  ///< named by the user: may also be a device or a pipe
    Kept    ///< kept by the program: must be a regular file; written so that it survives a power cut
};

/// All bytes of a regular file. Throws FileError if it cannot be read or has more than `most_bytes`, and for a pipe or
/// a device, for which nothing waits.
std::vector<std::uint8_t> read_file(const std::string& path, std::size_t most_bytes = kLargestFile_bytes);
/// `length` bytes of a file from an offset on. Throws FileError if they are missing or cannot be read.
std::vector<std::uint8_t> read_file_part(const std::string& path, std::uint64_t offset, std::size_t length);
/// A whole file as text.
std::string read_text(const std::string& path);

/// The path at the end of symbolic links; it need not exist. Throws FileError for a loop.
std::string end_of_links(const std::string& path);

/// Writes a whole file under a unique name beside the end of the path's links, then renames it: if anything fails, a
/// full disk or the power too, the old file stays. Throws FileError.
void write_file(const std::string& path, std::span<const std::uint8_t> bytes, FileUse use = FileUse::Named);
void write_file(const std::string& path, const std::string& text, FileUse use = FileUse::Named);
inline constexpr const char* kUnfinishedExtension = ".part";  ///< of the unique name

/// The same for a regular file (no link) whose old version is kept under another name, which it replaces. Whenever the
/// program ends, `path` or, if that is missing, `former_path` is a whole file.
void replace_file(const std::string& path, const std::string& former_path, std::span<const std::uint8_t> bytes);

/// Throws FileError if the path is a folder or in none: called before long work, whose result would be lost.
void check_writable(const std::string& path);

/// Removes those of the files that exist, durably. Throws FileError.
void remove_files(const std::vector<std::string>& paths);

/// Flushes standard output. Throws FileError if any output, now or before, could not be written.
void flush_standard_output();

/// Whether a path, by its text alone, is below a folder: it is relative, not empty, and has no "..".
bool stays_below(const std::string& path);

/// Whether a name leads out of a folder, by its text or, where it is there, over links.
bool leads_out(const std::string& folder, const std::string& name);

/// The regular file of that name in the first of the folders that has it and that it does not lead out of; empty if
/// there is none. What files name is looked for with these two alone.
std::string find_below(const std::vector<std::string>& folders, const std::string& name);

/// Makes a folder and those above it, durably, unless they exist. Throws FileError.
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

/// The folder of the running program. `called_as`: argv[0], for systems without /proc.
std::string program_folder(const char* called_as);

/// The folder of the project's own level, palette and sounds: in a build tree, beside the folder of the running program
/// (build/bin, build/assets); else where `cmake --install` puts it (PREFIX/share/oblong). `called_as` as in
/// program_folder(). Throws FileError if neither exists.
std::string assets_folder(const char* called_as);

}  // namespace oblong

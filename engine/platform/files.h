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

/// All bytes of a file. Throws FileError where it can't be read or has more than `most_bytes`.
std::vector<std::uint8_t> read_file(const std::string& path, std::size_t most_bytes = kLargestFile_bytes);
/// `length` bytes of a file from an offset on. Throws FileError where they can't be read or are not there.
std::vector<std::uint8_t> read_file_part(const std::string& path, std::uint64_t offset, std::size_t length);
/// A whole file as text.
std::string read_text(const std::string& path);

/// Writes a whole file under another name and renames it when it is complete: whatever fails, a full disk too, the old
/// file stays. Anything but a regular file (a device, a pipe, a link) is written to, never replaced. Throws FileError.
void write_file(const std::string& path, std::span<const std::uint8_t> bytes);
void write_file(const std::string& path, const std::string& text);

/// The same for a file that is there, which is kept under another name, in the place of what was there before. Whenever
/// the program ends: `path` or, where it is missing, `former_path` is a whole file.
void replace_file(const std::string& path, const std::string& former_path, std::span<const std::uint8_t> bytes);

/// Flushes standard output. Throws FileError if any output, now or before, could not be written.
void flush_standard_output();

/// Makes a folder and those above it, unless they are there. Throws FileError.
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

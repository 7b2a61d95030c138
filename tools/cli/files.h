#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace oblong {

/// An error in or about a file: `FILE: WHERE: what is wrong, what was expected`.
class FileError : public std::runtime_error {
  public:
    FileError(const std::string& path, const std::string& where, const std::string& what_is_wrong)
        : std::runtime_error(path + ": " + where + ": " + what_is_wrong) {}
};

/// A file's bytes. Throws FileError where it can't be read or has more than `most_bytes`.
std::vector<std::uint8_t> read_file(const std::string& path, std::size_t most_bytes = std::size_t{1} << 30);

/// Writes a whole file, or throws FileError and leaves none behind: it appears under its name when it is complete.
void write_file(const std::string& path, std::span<const std::uint8_t> bytes);
void write_file(const std::string& path, const std::string& text);

/// Makes a folder and those above it. Throws FileError.
void make_folder(const std::string& path);

/// parse(bytes of the file); InputErrors become FileErrors that name the file.
template <class Parse>
auto read_parsed(const std::string& path, Parse parse);

}  // namespace oblong

#include "engine/base/input_error.h"

namespace oblong {

template <class Parse>
auto read_parsed(const std::string& path, Parse parse) {
    const std::vector<std::uint8_t> bytes = read_file(path);
    try {
        return parse(bytes);
    } catch (const InputError& error) {
        throw FileError(path, error.where, error.what());
    }
}

}  // namespace oblong

#pragma once

#include <string>

namespace oblong::map {

/// The bytes of a file. Throws InputError if it cannot be read.
std::string read_file(const std::string& path);

/// Writes a file as a whole or, throwing InputError, not at all: under another name first, then renamed.
void write_file(const std::string& path, const std::string& bytes);

}  // namespace oblong::map

#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace oblong {

/// Writes a whole file under another name and renames it when it is complete: whatever fails, a full disk too, what was
/// there before stays. What is not a regular file (a device, a pipe) is written to, never replaced. Throws InputError
/// whose `where` is the path.
void replace_file(const std::string& path, std::span<const std::uint8_t> bytes);

}  // namespace oblong

#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace oblong {

/// Bytes as text of 64 characters (RFC 4648), for pictures within a page.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace oblong

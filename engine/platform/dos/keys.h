#pragma once

#include <cstdint>

namespace oblong::dos {

/// The USB HID usage of a key, by its scan code of set 1 without the bit of releasing; `is_extended`: it came after a
/// byte E0h. 0: none.
std::uint16_t key_usage(std::uint8_t scan_code, bool is_extended);

}  // namespace oblong::dos

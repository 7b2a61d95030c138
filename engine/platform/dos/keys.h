#pragma once

#include <cstdint>

namespace oblong::dos {

/// The USB HID usage of a key, from its scan code of set 1 without the release bit; `is_extended`: the code followed a
/// byte E0h. 0: none.
std::uint16_t key_usage(std::uint8_t scan_code, bool is_extended);

}  // namespace oblong::dos

#pragma once

#include <cstdint>

namespace oblong::dos {

/// What the loader (loader.S) hands over. Addresses are physical ones below 1 MB.
struct BootInfo {
    std::uint32_t segments;      ///< address of what LGDT reads: the loader's segments
    std::uint32_t leave_offset;  ///< in segment 0x18 of those: back to real mode, prints the message, ends
    char* words;                 ///< of the command line; end with a carriage return
    char* message;               ///< room for a text that ends with 0
    std::uint32_t message_size;
    std::uint8_t* exit_code;
};

}  // namespace oblong::dos

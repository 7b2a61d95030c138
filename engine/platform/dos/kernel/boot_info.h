#pragma once

#include <cstdint>

namespace oblong::dos {

/// A call of DOS (INT 21h), both data segments at BootInfo::buffer; and where the loader continues after it.
struct [[gnu::packed]] DosCall {
    std::uint32_t resume;
    std::uint16_t resume_segment, ax, bx, cx, dx, di, has_failed;
    std::uint8_t is_asked;
};

/// Data from the loader (loader.S). Addresses are physical, below 1 MB.
struct BootInfo {
    std::uint32_t segments;      ///< address of the LGDT operand for the loader's segments
    std::uint32_t leave_offset;  ///< in segment 0x18 of those: returns to real mode, prints the message, ends
    char* words;                 ///< of the command line; end with a carriage return
    char* message;               ///< room for a text that ends with 0
    std::uint32_t message_size;
    std::uint8_t* exit_code;
    DosCall* dos;          ///< null: started from a disk
    std::uint8_t* buffer;  ///< 64 KB
};

}  // namespace oblong::dos

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace oblong {

// Quake's pak files: "PACK", offset and length of the directory (u32 each, little-endian); a directory of entries of 64
// bytes: a zero-terminated name, as "maps/e1m1.bsp" (56 bytes), offset and length of the file (u32 each).

inline constexpr std::size_t kPakHeader_bytes = 12, kPakEntry_bytes = 64, kMostPakEntries = 65'536;

struct PakHeader {
    std::uint32_t directory_offset = 0, directory_length = 0;
};

struct PakEntry {
    std::string name;
    std::uint32_t offset = 0, length = 0;
};

/// Reads the first bytes of a file of `file_bytes`. Throws InputError unless its directory is inside it.
PakHeader read_pak_header(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes);

/// Reads the bytes of the directory. Throws InputError, with the offset in the file, for an entry without a name, a
/// name without an end, and data that is not all in the file or overlaps other data. Two entries may share all of their
/// data.
std::vector<PakEntry> read_pak_directory(std::span<const std::uint8_t> bytes, const PakHeader& header,
                                         std::uint64_t file_bytes);

}  // namespace oblong

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "engine/base/checksum.h"
#include "engine/pictures/bitmaps.h"

namespace oblong {
namespace {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kMostStoredBytes = 65'535;

void append_big_endian(Bytes& bytes, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

void append_chunk(Bytes& file, std::string_view name, ByteView content) {
    append_big_endian(file, static_cast<std::uint32_t>(content.size()));
    const std::size_t start = file.size();
    file.insert(file.end(), name.begin(), name.end());
    file.insert(file.end(), content.begin(), content.end());
    append_big_endian(file, crc32(ByteView(file.data(), file.size()).subspan(start)));
}

/// Bytes in zlib's format (RFC 1950), not compressed.
Bytes stored(ByteView bytes) {
    Bytes packed{0x78, 0x01};
    std::uint32_t a = 1, b = 0;
    for (std::size_t at = 0; at < bytes.size(); at += kMostStoredBytes) {
        const ByteView block = bytes.subspan(at, std::min(kMostStoredBytes, bytes.size() - at));
        packed.push_back(at + block.size() == bytes.size() ? 1 : 0);
        append_little_endian(packed, static_cast<std::uint16_t>(block.size()));
        append_little_endian(packed, static_cast<std::uint16_t>(~block.size()));
        packed.insert(packed.end(), block.begin(), block.end());
        for (const std::uint8_t byte : block) {
            a = (a + byte) % 65'521;
            b = (b + a) % 65'521;
        }
    }
    append_big_endian(packed, b << 16 | a);
    return packed;
}

}  // namespace

std::vector<std::uint8_t> encode_indexed_png(std::span<const std::uint8_t> pixels, std::int32_t width_px,
                                             std::int32_t height_px, const Palette& palette) {
    check_pixels_to_write(pixels.size(), width_px, height_px);
    Bytes head, colours, rows;
    append_big_endian(head, static_cast<std::uint32_t>(width_px));
    append_big_endian(head, static_cast<std::uint32_t>(height_px));
    head.insert(head.end(), {8, 3, 0, 0, 0});
    for (const Rgb8& colour : palette.colours) colours.insert(colours.end(), {colour.red, colour.green, colour.blue});
    for (std::int32_t y = 0; y < height_px; ++y) {
        rows.push_back(0);
        const ByteView row = pixels.subspan(pixel_count(width_px, y), static_cast<std::size_t>(width_px));
        rows.insert(rows.end(), row.begin(), row.end());
    }
    Bytes file(kSignature.begin(), kSignature.end());
    append_chunk(file, "IHDR", head);
    append_chunk(file, "PLTE", colours);
    append_chunk(file, "IDAT", stored(rows));
    append_chunk(file, "IEND", {});
    return file;
}

}  // namespace oblong

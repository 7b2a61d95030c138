#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "tools/png/indexed_png.h"

namespace oblong {
namespace {

using Bytes = std::span<const std::uint8_t>;
constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

std::uint32_t u32_big_endian(Bytes bytes) {
    return static_cast<std::uint32_t>(bytes[0]) << 24 | static_cast<std::uint32_t>(bytes[1]) << 16 |
           static_cast<std::uint32_t>(bytes[2]) << 8 | bytes[3];
}

/// What the chunks of a file hold.
struct Chunks {
    Bytes header, palette;
    std::vector<std::uint8_t> packed_rows;
};

/// Stops at the first chunk that the file has no room for.
Chunks collect_chunks(Bytes file) {
    constexpr std::size_t kFrameBytes = 12;  // length, letters, CRC
    Chunks chunks;
    std::size_t at = kSignature.size();
    while (file.size() - at >= kFrameBytes) {
        const std::size_t length = u32_big_endian(file.subspan(at, 4));
        if (length > file.size() - at - kFrameBytes) break;
        const std::string_view letters(reinterpret_cast<const char*>(file.data()) + at + 4, 4);
        const Bytes data = file.subspan(at + 8, length);
        if (letters == "IHDR") chunks.header = data;
        if (letters == "PLTE") chunks.palette = data;
        if (letters == "IDAT") chunks.packed_rows.insert(chunks.packed_rows.end(), data.begin(), data.end());
        at += kFrameBytes + length;
    }
    return chunks;
}

/// PNG's Paeth predictor: which of left, above and above-left is nearest to left + above - above-left.
int paeth(int left, int above, int above_left) {
    const int estimate = left + above - above_left;
    const int to_left = std::abs(estimate - left), to_above = std::abs(estimate - above);
    const int to_corner = std::abs(estimate - above_left);
    if (to_left <= to_above && to_left <= to_corner) return left;
    return to_above <= to_corner ? above : above_left;
}

int predicted(int filter, int left, int above, int above_left) {
    switch (filter) {
        case 1:
            return left;
        case 2:
            return above;
        case 3:
            return (left + above) / 2;
        case 4:
            return paeth(left, above, above_left);
        default:
            return 0;
    }
}

/// Undoes the filter of each row (its first byte) at a byte a pixel.
std::vector<std::uint8_t> unfilter(Bytes rows, std::size_t width, std::size_t height) {
    std::vector<std::uint8_t> pixels(width * height);
    for (std::size_t y = 0; y < height; ++y) {
        const Bytes row = rows.subspan(y * (width + 1), width + 1);
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t at = y * width + x;
            const int left = x > 0 ? pixels[at - 1] : 0, above = y > 0 ? pixels[at - width] : 0;
            const int above_left = x > 0 && y > 0 ? pixels[at - width - 1] : 0;
            pixels[at] = static_cast<std::uint8_t>(row[x + 1] + predicted(row[0], left, above, above_left));
        }
    }
    return pixels;
}

Palette palette_of(Bytes triples) {
    Palette palette;
    for (std::size_t i = 0; i * 3 + 2 < triples.size() && i < palette.colours.size(); ++i) {
        palette.colours[i] = {triples[i * 3], triples[i * 3 + 1], triples[i * 3 + 2]};
    }
    return palette;
}

/// Depth 8, colour type 3, and no interlacing.
bool is_plain_indexed(Bytes header) {
    return header.size() == 13 && header[8] == 8 && header[9] == 3 && header[12] == 0;
}

}  // namespace

std::optional<IndexedPng> decode_indexed_png(std::span<const std::uint8_t> file) {
    if (file.size() < kSignature.size() || !std::equal(kSignature.begin(), kSignature.end(), file.begin())) return {};
    const Chunks chunks = collect_chunks(file);
    if (!is_plain_indexed(chunks.header)) return {};
    const std::size_t width = u32_big_endian(chunks.header), height = u32_big_endian(chunks.header.subspan(4));
    constexpr std::size_t kLargest = 32768;
    if (width == 0 || height == 0 || width > kLargest || height > kLargest) return {};
    std::vector<std::uint8_t> rows((width + 1) * height);
    uLongf size = static_cast<uLongf>(rows.size());
    const auto packed_size = static_cast<uLong>(chunks.packed_rows.size());
    const int result = uncompress(rows.data(), &size, chunks.packed_rows.data(), packed_size);
    if (result != Z_OK || size != rows.size()) return {};
    return IndexedPng{static_cast<std::int32_t>(width), static_cast<std::int32_t>(height),
                      unfilter(rows, width, height), palette_of(chunks.palette)};
}

}  // namespace oblong

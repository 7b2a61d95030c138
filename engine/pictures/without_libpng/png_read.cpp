#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "engine/base/table.h"
#include "engine/pictures/bitmaps.h"

// PNGs with 8-bit palettes, as all of the game's own. Unpacked by stb.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_SIMD
#include <stb/stb_image.h>

namespace oblong {
namespace {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kHeadBytes = 13, kChunkBytes = 12;

std::uint32_t u32_at(ByteView bytes, std::size_t at) {
    expect_at(at, at + 4 <= bytes.size(), "the PNG ends here, expected all of it");
    return std::uint32_t{bytes[at]} << 24 | std::uint32_t{bytes[at + 1]} << 16 | std::uint32_t{bytes[at + 2]} << 8 |
           bytes[at + 3];
}

struct Chunks {
    ByteView head, palette, alphas;
    Bytes packed;
};

Chunks chunks_of(ByteView file) {
    expect_at(0, file.size() > kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), file.begin()),
              "not a PNG");
    Chunks chunks;
    for (std::size_t at = kSignature.size(); at < file.size();) {
        const std::size_t size = u32_at(file, at), left = file.size() - at;
        expect_at(at, left >= kChunkBytes && size <= left - kChunkBytes, "the PNG ends here, expected all of it");
        const std::string name(file.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                               file.begin() + static_cast<std::ptrdiff_t>(at) + 8);
        const ByteView bytes = file.subspan(at + 8, size);
        if (name == "IHDR") chunks.head = bytes;
        if (name == "PLTE") chunks.palette = bytes;
        if (name == "tRNS") chunks.alphas = bytes;
        if (name == "IDAT") chunks.packed.insert(chunks.packed.end(), bytes.begin(), bytes.end());
        at += kChunkBytes + size;
    }
    return chunks;
}

int predicted(int filter, int left, int above, int corner) {
    const int paeth = left + above - corner;
    const int by_left = std::abs(paeth - left), by_above = std::abs(paeth - above),
              by_corner = std::abs(paeth - corner);
    const int nearest = by_left <= by_above && by_left <= by_corner ? left : by_above <= by_corner ? above : corner;
    return std::array{0, left, above, (left + above) / 2, nearest}[as_size(filter)];
}

/// Converts rows, each of which begins with its filter type (PNG, 9.2), to indices.
Bytes unfiltered(ByteView rows, std::size_t width, std::size_t height) {
    Bytes pixels(width * height);
    for (std::size_t y = 0; y < height; ++y) {
        const ByteView row = rows.subspan(y * (width + 1), width + 1);
        if (row[0] > 4) refuse_picture("filter " + std::to_string(row[0]) + ", expected 0 to 4");
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t at = y * width + x;
            const int left = x > 0 ? pixels[at - 1] : 0, above = y > 0 ? pixels[at - width] : 0;
            const int corner = x > 0 && y > 0 ? pixels[at - width - 1] : 0;
            pixels[at] = static_cast<std::uint8_t>(row[x + 1] + predicted(row[0], left, above, corner));
        }
    }
    return pixels;
}

}  // namespace

PngImage decode_png(std::span<const std::uint8_t> file) {
    const Chunks chunks = chunks_of(file);
    const std::uint32_t width = u32_at(chunks.head, 0), height = u32_at(chunks.head, 4);
    const bool is_indexed = chunks.head.size() == kHeadBytes && chunks.head[8] == 8 && chunks.head[9] == 3 &&
                            chunks.head[12] == 0 && chunks.palette.size() >= 3;
    if (!is_indexed) refuse_picture("a PNG of another kind, expected 8-bit indices, not interlaced");
    check_picture_size(width, height);
    Bytes rows(std::size_t{width + 1} * height);
    const int unpacked = stbi_zlib_decode_buffer(reinterpret_cast<char*>(rows.data()), static_cast<int>(rows.size()),
                                                 reinterpret_cast<const char*>(chunks.packed.data()),
                                                 static_cast<int>(chunks.packed.size()));
    if (unpacked != static_cast<int>(rows.size())) refuse_picture("a damaged PNG");

    PngImage image{static_cast<std::int32_t>(width), static_cast<std::int32_t>(height), {}, {}};
    image.indices = unfiltered(rows, width, height);
    for (std::size_t i = 0; i < chunks.palette.size() / 3; ++i) {
        const ByteView rgb = chunks.palette.subspan(3 * i, 3);
        const std::uint8_t alpha = i < chunks.alphas.size() ? chunks.alphas[i] : std::uint8_t{255};
        image.colours.push_back({{rgb[0], rgb[1], rgb[2]}, alpha});
    }
    for (const std::uint8_t index : image.indices) palette_colour(image.colours, index);
    return image;
}

}  // namespace oblong

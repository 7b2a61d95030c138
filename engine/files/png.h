#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/surface/palette.h"

namespace oblong {

struct Rgba8 {
    Rgb8 colour;
    std::uint8_t alpha = 255;  ///< 0: transparent, 255: opaque
    constexpr bool operator==(const Rgba8&) const = default;
};

/// What a PNG file holds. Rows run from top to bottom.
struct PngImage {
    std::int32_t width_px = 0, height_px = 0;
    std::vector<std::uint8_t> indices;  ///< into `colours`, one a pixel; none where the PNG has no palette
    std::vector<Rgba8> colours;         ///< the PNG's palette (1 to 256), or without one a colour a pixel

    Rgba8 pixel(std::size_t at) const { return colours[indices.empty() ? at : indices[at]]; }
};

/// A PNG of any kind, 4096 pixels a side at most; colours are sRGB, as a gAMA chunk says. Throws InputError for bytes
/// that are no PNG or a damaged one (but damage to what does not change the picture passes).
PngImage decode_png(std::span<const std::uint8_t> file);

/// The bytes of a PNG file of colour type 3 (8-bit palette) that holds `pixels` (rows top to bottom, one palette index
/// each, exactly width_px * height_px of them) as they are. The same input gives the same file. Throws InputError where
/// the sizes do not agree.
std::vector<std::uint8_t> encode_indexed_png(std::span<const std::uint8_t> pixels, std::int32_t width_px,
                                             std::int32_t height_px, const Palette& palette);

}  // namespace oblong

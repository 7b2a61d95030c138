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

/// The contents of a PNG file. Rows run from top to bottom.
struct PngImage {
    std::int32_t width_px = 0, height_px = 0;
    std::vector<std::uint8_t> indices;  ///< into `colours`, one a pixel; empty if the PNG has no palette
    std::vector<Rgba8> colours;         ///< the PNG's palette (1 to 256), or else a colour for each pixel

    Rgba8 pixel(std::size_t at) const { return colours[indices.empty() ? at : indices[at]]; }
};

/// A PNG of any kind, up to 4096 pixels a side; colours are sRGB, converted by a gAMA chunk. Throws InputError for
/// bytes that are no PNG or a damaged one (damage that does not affect the picture is ignored).
PngImage decode_png(std::span<const std::uint8_t> file);

/// The bytes of a PNG file of colour type 3 (8-bit palette) with these `pixels` (rows top to bottom, one palette index
/// each, width_px * height_px of them). The same input gives the same file. Throws InputError if the sizes do not
/// agree.
std::vector<std::uint8_t> encode_indexed_png(std::span<const std::uint8_t> pixels, std::int32_t width_px,
                                             std::int32_t height_px, const Palette& palette);

/// A picture from an image editor: a PNG as decode_png() reads it, or a TGA, JPEG or BMP (not a compressed one), up to
/// 4096 pixels a side, as a colour for each pixel (their palettes are not kept). Throws InputError for any other bytes,
/// and for missing or damaged parts.
PngImage decode_picture(std::span<const std::uint8_t> file);

/// Up to `most` colours for pictures, from dark to bright: all of theirs if they have no more, else the means of groups
/// (median cut: Heckbert, "Color image quantization", SIGGRAPH 1982). Transparent pixels do not count.
std::vector<Rgb8> common_colours(std::span<const PngImage> images, std::size_t most);

/// How a picture is converted to a palette: each pixel to the nearest colour, or with the error of each pixel passed on
/// to its neighbours, so that the mean of a few pixels is right (Floyd and Steinberg 1976).
enum class Dither : std::uint8_t { None, FloydSteinberg };

/// Whether a picture's palette is the same as this one, or as its beginning.
bool has_palette(const PngImage& image, const Palette& palette);

/// An index of `range` for each pixel, ignoring transparency. A picture with this palette keeps its indices, of any
/// range: two indices may have the same colour, one of them glowing, so that only the index is unambiguous.
std::vector<std::uint8_t> indices_of(const PngImage& image, const Palette& palette, ColourRange range, Dither dither);

}  // namespace oblong

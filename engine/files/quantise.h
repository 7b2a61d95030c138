#pragma once

#include <cstdint>
#include <vector>

#include "engine/files/picture.h"
#include "engine/surface/palette.h"

namespace oblong {

/// How a picture is converted to a palette: each pixel to the nearest colour, or with the error of each pixel passed on
/// to its neighbours, so that the mean of a few pixels is right (Floyd and Steinberg 1976).
enum class Dither : std::uint8_t { None, FloydSteinberg };

/// Whether a picture's palette is the same as this one, or as its beginning.
bool has_palette(const PngImage& image, const Palette& palette);

/// An index of `range` for each pixel, ignoring transparency. A picture with this palette keeps its indices, of any
/// range: two indices may have the same colour, one of them glowing, so that only the index is unambiguous.
std::vector<std::uint8_t> indices_of(const PngImage& image, const Palette& palette, ColourRange range, Dither dither);

}  // namespace oblong

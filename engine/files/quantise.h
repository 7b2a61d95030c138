#pragma once

#include <cstdint>
#include <vector>

#include "engine/files/png.h"
#include "engine/surface/nearest_colour.h"
#include "engine/surface/palette.h"

namespace oblong {

/// How a picture of any colours gets those of a palette: each pixel the nearest, or with the error of each pixel passed
/// on to its neighbours, so that the mean of a few pixels is right (Floyd and Steinberg 1976).
enum class Dither : std::uint8_t { None, FloydSteinberg };

/// Whether a picture's own palette is this very one, or the beginning of it.
bool has_palette(const PngImage& image, const Palette& palette);

/// An index of `range` for each pixel; their transparency is not looked at. A picture that has this palette keeps its
/// indices, of any range: two indices may have the same colour, and one of the two glow, so that only an index says
/// which is meant.
std::vector<std::uint8_t> indices_of(const PngImage& image, const Palette& palette, ColourRange range, Dither dither);

}  // namespace oblong

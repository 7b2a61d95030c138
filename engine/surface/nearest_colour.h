#pragma once

#include <cstdint>

#include "engine/surface/palette.h"

namespace oblong {

/// A range of palette indices, `end` not included.
struct ColourRange {
    int begin = 0, end = 256;
};
inline constexpr ColourRange kOrdinaryColours{0, kFirstFullbright};

/// The index in `range` whose colour is nearest (squares of the differences of red, green and blue added up); the
/// lowest of several.
std::uint8_t nearest_colour(const Palette& palette, Rgb8 colour, ColourRange range = {});

}  // namespace oblong

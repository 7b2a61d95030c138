#pragma once

#include <cstdint>
#include <string_view>

#include "engine/surface/palette.h"

namespace oblong {

/// The last 32 colours of a palette glow: light does not change them.
inline constexpr int kFirstFullbright = 224;

/// In textures whose names begin with '{' the last colour is not drawn: a hole.
inline constexpr std::uint8_t kHole = 255;
inline bool has_holes(std::string_view texture_name) {
    return texture_name.starts_with('{');
}

/// A range of palette indices, `end` not included.
struct ColourRange {
    int begin = 0, end = 256;
};
inline constexpr ColourRange kOrdinaryColours{0, kFirstFullbright};

/// The index in `range` whose colour is nearest (squares of the differences of red, green and blue added up); the
/// lowest of several.
std::uint8_t nearest_colour(const Palette& palette, Rgb8 colour, ColourRange range);

}  // namespace oblong

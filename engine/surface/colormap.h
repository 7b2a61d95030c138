#pragma once

#include <array>
#include <cstdint>

#include "engine/surface/palette.h"

namespace oblong {

/// Shade x colour -> colour. Shade 0 is twice as bright as the colour, 32 the colour itself, 63 black; luminance never
/// rises with the shade.
struct Colormap {
    static constexpr int kShades = 64, kOwnShade = 32;
    std::array<std::array<std::uint8_t, 256>, kShades> shades{};
    Palette palette;  ///< whose colours these are
};

/// How bright a shade is: this many parts of `whole`, which is the colour itself.
struct ShadeLight {
    std::int32_t parts, whole;
};
/// In even steps from twice as bright down to the colour itself, and from there to black.
constexpr ShadeLight light_of_shade(int shade) {
    constexpr int kOwn = Colormap::kOwnShade, kDarkest = Colormap::kShades - 1;
    return shade < kOwn ? ShadeLight{2 * kOwn - shade, kOwn} : ShadeLight{kDarkest - shade, kDarkest - kOwn};
}

/// The colormap of a palette. A shade of a colour is the palette entry perceived as nearest to the colour's channels
/// times the shade's light (up to 255), where a wrong hue weighs more than a wrong lightness: so that a ramp of shades
/// keeps its hue. The last `fullbright_count` colours glow: they are the same in every shade, and no other colour
/// becomes one (Quake's last 32).
Colormap make_colormap(const Palette& palette, int fullbright_count = 32);

/// The colormap with only `count` different shades, 16, 32 or 64, half of them up to the colour itself: each of 64 is
/// replaced by one of them, the next brighter one up to the colour itself.
Colormap with_shades(const Colormap& colormap, std::int32_t count);

}  // namespace oblong

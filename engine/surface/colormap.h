#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/surface/palette.h"

namespace oblong {

/// A colour in OKLab (Ottosson 2020), with 14 fraction bits: lightness 0 to 1; green to red and blue to yellow, each
/// within +-0.32.
struct Oklab {
    std::int32_t lightness_14 = 0, green_red_14 = 0, blue_yellow_14 = 0;
};

/// A colour in sRGB, channels 0 to 255 with 8 fraction bits: whole steps would lose the hue of dark shades.
struct FineRgb {
    std::int32_t red_8 = 0, green_8 = 0, blue_8 = 0;
};

/// Within 2^-12 of the exact values.
Oklab oklab_of(const FineRgb& colour);

/// Maps shade and colour to a colour. Shade 0 is twice as bright as the colour, 32 the colour itself, 63 black;
/// luminance never rises with the shade.
struct Colormap {
    static constexpr int kShades = 64, kOwnShade = 32;
    std::array<std::array<std::uint8_t, 256>, kShades> shades{};
    Palette palette;  ///< of these colours
};

/// The brightness of a shade, parts / whole; 1 is the colour itself.
struct ShadeLight {
    std::int32_t parts, whole;
};
/// Linear from twice as bright down to the colour itself, and from there to black.
constexpr ShadeLight light_of_shade(int shade) {
    constexpr int kOwn = Colormap::kOwnShade, kDarkest = Colormap::kShades - 1;
    return shade < kOwn ? ShadeLight{2 * kOwn - shade, kOwn} : ShadeLight{kDarkest - shade, kDarkest - kOwn};
}

/// The colormap of a palette. A shade of a colour is the palette entry perceptually nearest to the colour's channels
/// times the shade's light (up to 255). An error of hue weighs more than one of lightness, so that a ramp of shades
/// keeps its hue. Colours from `first_fullbright` on (in Quake the last 32) are the same in every shade, and no other
/// colour is mapped to them.
Colormap make_colormap(const Palette& palette, std::size_t first_fullbright = kFirstFullbright);

/// The palette's colours for texels in coloured light: red, green and blue have `levels` values each, evenly from 0 to
/// 255.
struct ColourCube {
    std::int32_t levels = 0;                                  ///< 2 to 64
    std::vector<std::uint8_t> nearest;                        ///< by (red * levels + green) * levels + blue
    std::array<std::array<std::int32_t, 4>, 256> levels_8{};  ///< of each colour's channels, with 8 fraction bits
    /// A channel's part of an index of `nearest`, by its level in up to twice full light.
    std::array<std::array<std::int32_t, 128>, 3> parts{};
};

/// Each entry is the ordinary colour perceptually nearest, as in a colormap. Some milliseconds at 32 levels.
ColourCube make_colour_cube(const Palette& palette, std::int32_t levels);

/// The colormap reduced to `count` shades, 16, 32 or 64, half of them brighter than the colour itself. Each of the 64
/// is replaced by one of these, in the brighter half by the next brighter one.
Colormap with_shades(const Colormap& colormap, std::int32_t count);

}  // namespace oblong

#pragma once

#include "engine/base/table.h"
#include "engine/surface/lit_surface.h"
#include "tests/support/palettes.h"
#include "tests/support/random.h"

namespace oblong::test {

/// Lightness, green to red, blue to yellow.
using TrueOklab = std::array<double, 3>;

/// Ottosson's formulas in doubles; channels of sRGB from 0 to 255.
inline TrueOklab true_oklab(double red, double green, double blue) {
    const auto linear = [](double channel) {
        const double c = channel / 255;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double r = linear(red), g = linear(green), b = linear(blue);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

/// A difference of hue counts eight times one of lightness, as in a colormap.
inline double distance(const TrueOklab& a, const TrueOklab& b) {
    const double lightness = a[0] - b[0], green_red = a[1] - b[1], blue_yellow = a[2] - b[2];
    return std::sqrt(lightness * lightness + 8 * (green_red * green_red + blue_yellow * blue_yellow));
}
/// What is left of a colour in some light, 1: itself.
inline TrueOklab seen(const Rgb8& colour, double light = 1) {
    const auto channel = [=](std::uint8_t full) { return std::min(full * light, 255.0); };
    return true_oklab(channel(colour.red), channel(colour.green), channel(colour.blue));
}

inline Palette random_palette(auto& random) {
    Palette palette;
    for (Rgb8& colour : palette.colours) colour = {random_byte(random), random_byte(random), random_byte(random)};
    return palette;
}

/// The step of ordered dithering at a texel, sixteenths.
inline int dither_16(std::int32_t x, std::int32_t y) {
    constexpr int kBayer[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    return kBayer[y % 4][x % 4];
}
/// The texel of a repeated texture.
inline std::uint8_t wrapped_texel(const TextureView& texture, std::int32_t x, std::int32_t y) {
    const auto wrapped = [](std::int32_t place, std::int32_t size) { return ((place % size) + size) % size; };
    return texture
        .texels[wrapped(texture.min_v + y, texture.height) * texture.width + wrapped(texture.min_u + x, texture.width)];
}

}  // namespace oblong::test

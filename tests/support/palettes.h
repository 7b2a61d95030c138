#pragma once

#include <algorithm>
#include <numeric>

#include "engine/surface/colormap.h"
#include "engine/surface/lit_surface.h"

namespace oblong::test {

/// Colour i is grey i.
inline Palette grey_palette() {
    Palette palette;
    for (std::size_t i = 0; i < 256; ++i) {
        const auto grey = static_cast<std::uint8_t>(i);
        palette.colours[i] = {grey, grey, grey};
    }
    return palette;
}

/// Every shade of a colour is the colour itself.
inline Colormap unshaded() {
    Colormap colormap;
    for (auto& shade : colormap.shades) std::iota(shade.begin(), shade.end(), std::uint8_t{0});
    return colormap;
}
/// Every colour becomes the number of its shade.
inline Colormap numbered_shades() {
    Colormap colormap;
    std::uint8_t number = 0;
    for (auto& shade : colormap.shades) shade.fill(number++);
    return colormap;
}

/// The shade of a lightmap value: twice full light is shade 0, full light 32, none 63.
inline double shade_in_doubles(double light) {
    return light < kFullLight ? 32 + (kFullLight - light) * 31 / kFullLight
                              : std::max(2 * kFullLight - light, 0.0) * 32 / kFullLight;
}

}  // namespace oblong::test

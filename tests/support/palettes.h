#pragma once

#include <numeric>

#include "engine/surface/colormap.h"

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

}  // namespace oblong::test

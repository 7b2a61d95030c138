#pragma once

#include "engine/surface/palette.h"

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

}  // namespace oblong::test

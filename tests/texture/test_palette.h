#pragma once

#include <cstdint>
#include <vector>

#include "engine/surface/palette.h"

namespace oblong::test {

/// 256 different colours in no order: red and green count up in steps, blue mixes both.
inline Palette scattered_palette() {
    Palette palette;
    for (int i = 0; i < 256; ++i) {
        palette.colours[static_cast<std::size_t>(i)] = {static_cast<std::uint8_t>(i % 16 * 17),
                                                        static_cast<std::uint8_t>(i / 16 * 17),
                                                        static_cast<std::uint8_t>(i * 7)};
    }
    return palette;
}

/// Texels without a pattern, of colours below `colour_count`.
inline std::vector<std::uint8_t> scattered_texels(int count, int colour_count) {
    std::vector<std::uint8_t> texels;
    std::uint32_t state = 12345;
    for (int i = 0; i < count; ++i) {
        state = state * 1664525u + 1013904223u;
        texels.push_back(static_cast<std::uint8_t>((state >> 20) % static_cast<std::uint32_t>(colour_count)));
    }
    return texels;
}

}  // namespace oblong::test

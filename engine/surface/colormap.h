#pragma once

#include <array>
#include <cstdint>

#include "engine/surface/palette.h"

namespace oblong {

/// Shade x colour -> colour. Shade 0 is the colour itself, 63 the darkest; luminance never rises with the shade.
struct Colormap {
    static constexpr int kShades = 64;
    std::array<std::array<std::uint8_t, 256>, kShades> shades{};
};

/// The colormap of a palette: the palette entry nearest to the colour times (63 - shade) / 63. The last
/// `fullbright_count` colours glow: they are the same in every shade, and no other colour becomes one (Quake's last
/// 32).
Colormap make_colormap(const Palette& palette, int fullbright_count = 32);

}  // namespace oblong

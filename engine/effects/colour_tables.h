#pragma once

#include <array>
#include <cstdint>

#include "engine/raster/kernels/effect_kernels.h"
#include "engine/surface/palette.h"

namespace oblong {

/// What a mixture of two colours looks like: `share_256` of the front one, 0 to 256. With share 0 every row is the
/// colours behind, with 256 the colour in front, and a colour over itself is itself. 64 KiB: made when a frame
/// first calls for it.
BlendTable make_blend_table(const Palette& palette, std::int32_t share_256);

/// Colours seen through fog: level 0 is clear, level k has k / 63 of the densest fog.
struct FogTable {
    static constexpr int kLevels = 64;
    std::array<ColourRow, kLevels> levels{};
};

/// The table of a fog of this colour, of whose densest `share_256` hides what is behind it, 0 to 256.
FogTable make_fog_table(const Palette& palette, Rgb8 fog, std::int32_t share_256 = 256);
/// One of its levels.
ColourRow make_fog_level(const Palette& palette, Rgb8 fog, std::int32_t share_256, int level);

}  // namespace oblong

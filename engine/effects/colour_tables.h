#pragma once

#include <array>
#include <cstdint>

#include "engine/raster/kernels/effect_kernels.h"
#include "engine/surface/palette.h"

namespace oblong {

/// Mixtures of two colours with `share_256` (0 to 256) of the front one. Share 0 gives the colour behind, 256 the front
/// colour; a colour over itself is unchanged. 64 KiB; made when a frame first needs it.
BlendTable make_blend_table(const Palette& palette, std::int32_t share_256);

/// Colours seen through fog. Level 0 is clear, level k has k / 63 of the densest fog.
struct FogTable {
    static constexpr int kLevels = 64;
    std::array<ColourRow, kLevels> levels{};
};

/// The table of a fog of this colour; the densest fog hides `share_256` (0 to 256) of what is behind it.
FogTable make_fog_table(const Palette& palette, Rgb8 fog, std::int32_t share_256 = 256);
/// One level of make_fog_table().
ColourRow make_fog_level(const Palette& palette, Rgb8 fog, std::int32_t share_256, int level);

}  // namespace oblong

#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/raster/kernels/kernels.h"

namespace oblong {

/// The most that a warp moves texels.
inline constexpr std::uint32_t kGreatestShift_texels = 16;

/// The warp of one mip level: how far texels move along one axis, by their coordinate on the other: 0 to twice the
/// amplitude, texels, 16.16. Entry i is for columns or rows i, i + 128, i + 256 ...
struct WarpTable {
    static constexpr std::uint32_t kEntries = 128;
    std::array<std::uint32_t, kEntries> shift_16{};
};

/// How far the texels in the column or row of `texel_16` are moved.
inline std::uint32_t shift_at(const WarpTable& warp, std::uint32_t texel_16) {
    return warp.shift_16[(texel_16 >> 16) % WarpTable::kEntries];
}

/// Colour in front x colour behind -> the colour seen.
struct BlendTable {
    std::array<std::array<std::uint8_t, 256>, 256> rows{};
};

/// Colour -> colour.
using ColourRow = std::array<std::uint8_t, 256>;

/// The texel that is a hole.
inline constexpr std::uint8_t kHoleTexel = 255;

/// The arguments of an effect kernel; what its traits do not need may be null.
struct EffectTexels {
    SurfaceView surface;
    const WarpTable* warp = nullptr;     ///< for surfaces that warp
    const ColourRow* colours = nullptr;  ///< for holes and blending: maps texels to fogged ones, or identity
    const BlendTable* blend = nullptr;   ///< for blending
};

/// The effects of a surface.
struct TexelTraits {
    bool warps = false;               ///< u is moved by the warp at v, and v by that at u
    bool has_holes = false;           ///< texels kHoleTexel leave the pixel unchanged
    bool blends = false;              ///< the pixel below shows through
    bool is_wrapped_by_masks = true;  ///< false: any size, wrapped by division, stride = width
};

inline constexpr TexelTraits kWarpsAlone{.warps = true};

/// The kernel for these traits; it does no work for traits that are false.
EffectKernel effect_kernel(TexelTraits traits, const Kernels& kernels);
/// The same in portable C++.
EffectKernel plain_effect_kernel(TexelTraits traits);

}  // namespace oblong

#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/raster/kernels/kernels.h"

namespace oblong {

/// The most that a warp moves texels.
inline constexpr std::uint32_t kGreatestShift_texels = 16;

/// How far texels of one mip level are moved along one axis by their place on the other: from 0 to twice the
/// amplitude, texels, 16.16. Entry i is for the columns or rows i, i + 128, i + 256 ...
struct WarpTable {
    static constexpr std::uint32_t kEntries = 128;
    std::array<std::uint32_t, kEntries> shift_16{};
};

/// How far texels of the column or row of this one are moved.
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

/// A surface and what its kernel needs to draw it; the rest may be null.
struct EffectTexels {
    SurfaceView surface;
    const WarpTable* warp = nullptr;    ///< for surfaces that warp
    const ColourRow* shades = nullptr;  ///< for those with holes or blended: what fog makes of texels, or identity
    const BlendTable* blend = nullptr;  ///< for blended ones
};

/// What a surface needs in addition to plain texels.
struct TexelTraits {
    bool warps = false;               ///< u is moved by the warp of v, and v by that of u
    bool has_holes = false;           ///< pixels where the texel is kHoleTexel stay
    bool blends = false;              ///< the pixel below shows through
    bool is_wrapped_by_masks = true;  ///< false: of any size, wrapped by division, its stride its width
};

using EffectKernel = void (*)(std::span<const TexelBlock> blocks, const EffectTexels& texels, std::uint8_t* pixels);

/// The kernel of a surface with these traits, the fastest that the processor runs. What a surface does not need, its
/// kernel does not ask about.
EffectKernel effect_kernel(TexelTraits traits, bool has_bmi2 = oblong::has_bmi2());

inline constexpr TexelTraits kWarpsAlone{.warps = true};

/// Of a surface that warps and does nothing else: u and v in one word, as draw_blocks_bmi2. Only where has_bmi2().
void draw_warped_blocks_bmi2(std::span<const TexelBlock> blocks, const EffectTexels& texels, std::uint8_t* pixels);

}  // namespace oblong

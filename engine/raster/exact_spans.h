#pragma once

#include <cstdint>
#include <span>

#include "engine/raster/kernels/effect_kernels.h"
#include "engine/raster/texture_blocks.h"

namespace oblong {

/// Draws spans of a surface that is wrapped by masks, each pixel as a division there gives it: the same bytes as
/// Texturing::Exact's blocks of one pixel, without the blocks. `kernels` draw pieces whose texture coordinates are
/// almost linear, without a division for most pixels; null if such pieces are too short to be worth a search.
/// Reads gradients, limits and fits_range of `cutting`. Returns the number of divisions.
std::int64_t draw_exact_spans(std::span<const Span> spans, const BlockCutting& cutting, const SurfaceView& surface,
                              const Kernels* kernels, Framebuffer out);

/// The same for a surface that warps and has no other effect.
std::int64_t draw_exact_warped_spans(std::span<const Span> spans, const BlockCutting& cutting,
                                     const EffectTexels& texels, Framebuffer out);

}  // namespace oblong

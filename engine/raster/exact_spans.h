#pragma once

#include <cstdint>
#include <span>

#include "engine/raster/kernels/effect_kernels.h"
#include "engine/raster/texture_blocks.h"

namespace oblong {

/// Draws spans of a surface that its masks wrap with a division at each pixel: the same bytes as by Texturing::Exact's
/// blocks of one pixel, without the blocks. `kernel` draws pieces whose texels lie almost on a line, without a division
/// for most of their pixels; null where such pieces are too short to be worth looking for. With AVX-512 a division for
/// each of eight pixels at a time takes less, and there are no pieces. Of the cutting, gradients, limits and fits_range
/// are looked at. Returns how many divisions it made.
std::int64_t draw_exact_spans(std::span<const Span> spans, const BlockCutting& cutting, const SurfaceView& surface,
                              BlockKernel kernel, Framebuffer out, Instructions instructions = best_instructions());

/// The same of a surface that warps and does nothing else.
std::int64_t draw_exact_warped_spans(std::span<const Span> spans, const BlockCutting& cutting,
                                     const EffectTexels& texels, Framebuffer out);

}  // namespace oblong

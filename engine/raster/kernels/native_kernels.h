#pragma once

#include "engine/raster/kernels/kernels.h"

// The kernels of each instruction set: choice.cpp alone names them. Each file is empty for other processors.

namespace oblong {

/// vectors.cpp: four pixels at a time, in the vectors of SSE2, NEON or AltiVec.
void draw_blocks_by_fours(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);

/// i386.cpp
void draw_blocks_i386(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);

/// sse2.cpp: eight pixels or texels at a time.
std::uint64_t pixels_near_borders_sse2(const TexelBlock& block, std::uint32_t error_16);
PixelRange inside_edges_sse2(const EdgeRow& row, std::int32_t count);
void light_cells_sse2(const LitCells& cells, int mip, const Colormap& colormap);

/// bmi2.cpp: u and v in one word, of which one `pext` extracts the texel's offset; eight pixels are stored at once.
void draw_blocks_bmi2(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
void draw_warped_blocks_bmi2(std::span<const TexelBlock> blocks, const EffectTexels& texels, std::uint8_t* pixels);
std::span<const Span> cut_bounded_bmi2(std::span<const Span> spans, std::int32_t pitch, const BlockCutting& cutting,
                                       BlockList& blocks);

}  // namespace oblong

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "engine/surface/lit_surface.h"
#include "engine/view/screen.h"

namespace oblong {

struct BlockCutting;
class BlockList;
struct EffectTexels;

/// A run of pixels with linear texture coordinates: texels, 16.16, from 0 to 65,535 at every pixel.
struct TexelBlock {
    std::uint32_t pixel;  ///< index of the first pixel in the framebuffer
    std::int32_t count;
    std::uint32_t u_16, v_16;
    std::int32_t u_step_16, v_step_16;
};

/// A triangle's three edge functions along a row of pixels: at the first one, and their step to the next. A pixel is
/// inside if none is below 0.
struct EdgeRow {
    std::array<std::int64_t, 3> value, step;
};

/// Draws blocks of a surface whose sizes are powers of two.
using BlockKernel = void (*)(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
/// Draws blocks of a surface with an effect.
using EffectKernel = void (*)(std::span<const TexelBlock> blocks, const EffectTexels& texels, std::uint8_t* pixels);
/// One bit for each pixel of a block of up to 64, the first in the lowest bit: whether u or v is near a whole texel,
/// less than `error_16` (2^-16 texel) above it or at most that below it. The error is below a quarter of a texel.
using BorderKernel = std::uint64_t (*)(const TexelBlock& block, std::uint32_t error_16);
/// Which of a row's first `count` pixels are inside: consecutive ones, since a triangle is convex. All values for the
/// pixels must fit 32 bits.
using EdgeRowKernel = PixelRange (*)(const EdgeRow& row, std::int32_t count);
/// Appends the blocks of spans (texture_blocks.h), left to right, while there is room for a span's worst case. Returns
/// the remaining spans. `pitch` is the framebuffer's.
using BlockCutter = std::span<const Span> (*)(std::span<const Span> spans, std::int32_t pitch,
                                              const BlockCutting& cutting, BlockList& blocks);

/// The code that draws, for one instruction set. All write the same bytes as the plain one.
struct Kernels {
    const char* name;
    BlockKernel draw_blocks;
    BorderKernel pixels_near_borders;
    EdgeRowKernel inside_edges;
    CellKernel light_cells;    ///< null: a texel at a time
    EffectKernel draw_warped;  ///< of surfaces that warp and have no other effect; null: as with other effects
    BlockCutter cut_bounded;   ///< for Texturing::Bounded with divided reciprocals; null: as for all other dials
};

/// The kernels that this processor can run, the best first, "plain" last: portable C++, written in the most direct way.
std::span<const Kernels> all_kernels();
/// By name: "bmi2", "baseline" (what all processors of the target have), "plain"; null if this processor has none.
const Kernels* find_kernels(std::string_view name);
inline const Kernels& best_kernels() {
    return all_kernels().front();
}

void draw_blocks_plain(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
/// SIMD within a register: u and v in one 64-bit word, so that one addition steps both.
void draw_blocks_packed(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
/// Wraps by division, for tiles whose sizes are not powers of two; uses width, height and a stride of width.
void draw_blocks_any_size(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
std::uint64_t pixels_near_borders_plain(const TexelBlock& block, std::uint32_t error_16);
PixelRange inside_edges_plain(const EdgeRow& row, std::int32_t count);

}  // namespace oblong

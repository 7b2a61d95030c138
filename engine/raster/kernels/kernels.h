#pragma once

#include <cstdint>
#include <span>

#include "engine/surface/lit_surface.h"

namespace oblong {

/// A run of pixels with linear texture coordinates: texels, 16.16, from 0 to 65,535 at every pixel.
struct TexelBlock {
    std::uint32_t pixel;  ///< index of the first pixel in the framebuffer
    std::int32_t count;
    std::uint32_t u_16, v_16;
    std::int32_t u_step_16, v_step_16;
};

/// Draws blocks of a surface whose sizes are powers of two. Every kernel writes the same bytes as draw_blocks_plain.
using BlockKernel = void (*)(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);

/// The reference implementation, written in the most direct way.
void draw_blocks_plain(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
/// SIMD within a register: u and v in one 64-bit word, so that one addition steps both.
void draw_blocks_packed(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
/// Four pixels at a time, in the vectors that all processors of the target have: SSE2 on x86-64, NEON on AArch64;
/// otherwise draw_blocks_packed.
void draw_blocks_by_fours(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
/// As draw_blocks_packed, but extracts the texel's offset with one `pext` and stores eight pixels at once. Only if
/// has_bmi2().
void draw_blocks_bmi2(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
/// Wraps by division, for tiles whose sizes are not powers of two; uses width, height and a stride of width.
void draw_blocks_any_size(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);

/// Whether this processor has AVX, and BMI2 with a fast `pext`.
bool has_bmi2();

/// Instruction sets of x86-64 processors; each includes those before it.
enum class Instructions : std::uint8_t {
    Baseline,
    Bmi2  ///< has_bmi2()
};
/// The last that this processor has.
Instructions best_instructions();

struct NamedKernel {
    const char* name;
    BlockKernel draw;
};
/// The kernels that this processor can run, fastest first.
std::span<const NamedKernel> block_kernels();
BlockKernel best_block_kernel();

/// The reference implementation, one pixel at a time. One bit for each pixel of a block of up to 64, the first in the
/// lowest bit: whether u or v is near a whole texel, less than `error_16` (2^-16 texel) above it or at most that below
/// it. The error is below a quarter of a texel.
std::uint64_t pixels_near_borders_plain(const TexelBlock& block, std::uint32_t error_16);
/// Eight pixels at a time with SSE2; otherwise as plain.
std::uint64_t pixels_near_borders(const TexelBlock& block, std::uint32_t error_16);

}  // namespace oblong

#pragma once

#include <cstdint>
#include <span>

#include "engine/surface/lit_surface.h"

namespace oblong {

/// A run of pixels whose texture coordinates step evenly: texels, 16.16, never below 0 nor above 65,535 on the way.
struct TexelBlock {
    std::uint32_t pixel;  ///< index of the first pixel in the framebuffer
    std::int32_t count;
    std::uint32_t u_16, v_16;
    std::int32_t u_step_16, v_step_16;
};

/// Draws blocks of a surface whose sizes are powers of two. Every kernel writes the same bytes as draw_blocks_plain.
using BlockKernel = void (*)(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);

/// The reference implementation: the same arithmetic, in the most direct way.
void draw_blocks_plain(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
/// SIMD within a register: u and v in one 64-bit word, so that one addition steps both.
void draw_blocks_packed(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
/// Four pixels at a time, in the vectors that all processors of the target have: SSE2 of x86-64, NEON of AArch64. On
/// others it is draw_blocks_packed.
void draw_blocks_by_fours(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
/// As draw_blocks_packed, the texel's offset taken from the word by one `pext`. Only where has_bmi2().
void draw_blocks_bmi2(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);
/// Any size of texture: wraps by division. For tiles whose sizes are not powers of two; uses width, height and a stride
/// of width.
void draw_blocks_any_size(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels);

/// Whether this processor has the BMI2 instructions, and a fast `pext` among them.
bool has_bmi2();

/// What an x86-64 processor has beyond what all of them have, each with what is before it.
enum class Instructions : std::uint8_t {
    Baseline,
    Bmi2,   ///< has_bmi2()
    Avx512  ///< vectors of 512 bits: AVX-512 F, CD and DQ
};
/// The most that this processor has.
Instructions best_instructions();

struct NamedKernel {
    const char* name;
    BlockKernel draw;
};
/// The kernels that this processor runs, the fastest first.
std::span<const NamedKernel> block_kernels();
/// The fastest kernel that this processor runs.
BlockKernel best_block_kernel();

/// A bit for each pixel of a block of up to 64 (its first is the lowest) whose u or v is nearer than `error_16` units
/// of 2^-16 to a whole texel: at most that much behind it, or less before it. The error is below a quarter of a texel.
using BorderKernel = std::uint64_t (*)(const TexelBlock& block, std::uint32_t error_16);

/// The reference implementation: a pixel at a time.
std::uint64_t pixels_near_borders_plain(const TexelBlock& block, std::uint32_t error_16);
/// SSE2, eight pixels at a time (plain where the processor has none).
std::uint64_t pixels_near_borders(const TexelBlock& block, std::uint32_t error_16);

}  // namespace oblong

#include <bit>
#include <cstddef>
#include <cstring>

#include "engine/raster/kernels/packed.h"

namespace oblong {

#if defined(__SSE2__) || defined(__ARM_NEON) || defined(__ALTIVEC__)

namespace {

using Four = std::uint32_t __attribute__((vector_size(16)));
using TwoPairs = std::uint64_t __attribute__((vector_size(16)));

/// Offsets of texels in a surface.
struct FourOffsets {
    Four u_mask, row_mask;
    int row_shift;

    explicit FourOffsets(const SurfaceView& surface)
        : u_mask(Four{} + surface.u_mask),
          row_mask(Four{} + (surface.v_mask << surface.stride_log2)),
          row_shift(16 - surface.stride_log2) {}

    Four at(Four u, Four v) const { return ((v >> row_shift) & row_mask) | ((u >> 16) & u_mask); }
};

/// 0, 1, 2 and 3 steps, without a multiplication, which SSE2 lacks.
Four steps_to_each(Four step) {
    return (step & Four{0, ~0u, 0, ~0u}) + ((step << 1) & Four{0, 0, ~0u, ~0u});
}

/// Extracts two offsets at a time; the order of the halves depends on the byte order.
void draw_four(Four offsets, const std::uint8_t* texels, std::uint8_t* out) {
    constexpr int kFirst = std::endian::native == std::endian::little ? 0 : 32, kSecond = 32 - kFirst;
    const auto pairs = reinterpret_cast<TwoPairs>(offsets);
    out[0] = texels[static_cast<std::uint32_t>(pairs[0] >> kFirst)];
    out[1] = texels[static_cast<std::uint32_t>(pairs[0] >> kSecond)];
    out[2] = texels[static_cast<std::uint32_t>(pairs[1] >> kFirst)];
    out[3] = texels[static_cast<std::uint32_t>(pairs[1] >> kSecond)];
}

/// Draws a block of at least four pixels.
void draw_by_fours(const TexelBlock& block, const FourOffsets& offsets, const std::uint8_t* texels, std::uint8_t* out) {
    Four all;  // u, v and their steps
    std::memcpy(&all, &block.u_16, sizeof all);
    const Four u_step = __builtin_shufflevector(all, all, 2, 2, 2, 2);
    const Four v_step = __builtin_shufflevector(all, all, 3, 3, 3, 3);
    Four u = __builtin_shufflevector(all, all, 0, 0, 0, 0) + steps_to_each(u_step);
    Four v = __builtin_shufflevector(all, all, 1, 1, 1, 1) + steps_to_each(v_step);
    const Four u_step_4 = u_step << 2, v_step_4 = v_step << 2;
    std::uint8_t* const end = out + block.count;
    for (; end - out >= 4; out += 4, u += u_step_4, v += v_step_4) draw_four(offsets.at(u, v), texels, out);
    const Four rest = offsets.at(u, v);
    for (int i = 0; out != end; ++i) *out++ = texels[rest[i]];
}

}  // namespace

void draw_blocks_by_fours(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    const FourOffsets offsets(surface);
    const PackedFetch fetch(surface);
    for (const TexelBlock& block : blocks) {
        if (block.count < 4)
            draw_packed_block(block, pixels, fetch);
        else
            draw_by_fours(block, offsets, surface.texels, pixels + block.pixel);
    }
}

#elif defined(__i386__)

namespace {

/// The steps of a block that stays within its surface.
struct TexelWalk {
    std::uint32_t u_fraction, v_fraction;  ///< of the steps, 0.32: sums carry into whole texels
    std::int32_t texels[2];                ///< whole steps as offsets in the surface: with a carry of v, and without
    std::uint8_t* end;                     ///< of the pixels drawn four at a time
};

// To the next texel, in four instructions, three of them for the carries; two pixels are written at once.
#define OBLONG_NEXT_TEXEL       \
    "addl 4(%[walk]), %[v]\n\t" \
    "sbbl %%eax, %%eax\n\t"     \
    "addl (%[walk]), %[u]\n\t"  \
    "adcl 12(%[walk], %%eax, 4), %[texel]\n\t"
#define OBLONG_PIXEL(HALF) "movb (%[texel]), %%" HALF "\n\t" OBLONG_NEXT_TEXEL

/// A walk's place, which needs all registers.
struct TexelPlace {
    const std::uint8_t* texel;
    std::uint32_t u, v;  ///< fractions, 0.32
    std::uint8_t* out;

    /// Draws to the walk's end, which is a multiple of four pixels away, at least four.
    [[gnu::always_inline]] void draw_fours(const TexelWalk& walk) {
        static_assert(offsetof(TexelWalk, v_fraction) == 4 && offsetof(TexelWalk, texels) == 8 &&
                      offsetof(TexelWalk, end) == 16);
        asm volatile("0:\n\t" OBLONG_PIXEL("dl") OBLONG_PIXEL("dh") "movw %%dx, (%[out])\n\t"
                     OBLONG_PIXEL("dl") OBLONG_PIXEL("dh") "movw %%dx, 2(%[out])\n\t"
                     "addl $4, %[out]\n\t"
                     "cmpl 16(%[walk]), %[out]\n\t"
                     "jne 0b"
                     : [texel] "+r"(texel), [u] "+r"(u), [v] "+r"(v), [out] "+r"(out)
                     : [walk] "r"(&walk)
                     : "eax", "edx", "cc", "memory");
    }
    [[gnu::always_inline]] void draw_two(const TexelWalk& walk) {
        asm volatile(OBLONG_PIXEL("dl") OBLONG_PIXEL("dh") "movw %%dx, (%[out])\n\t"
                     "addl $2, %[out]"
                     : [texel] "+r"(texel), [u] "+r"(u), [v] "+r"(v), [out] "+r"(out)
                     : [walk] "r"(&walk)
                     : "eax", "edx", "cc", "memory");
    }
};

/// Any block; a function of its own, for the sake of the other's registers.
[[gnu::noinline]] void draw_any(const TexelBlock& block, const SurfaceView& surface, std::uint8_t* pixels) {
    draw_packed_block(block, pixels, PackedFetch(surface));
}

/// What blocks of a surface share, in a copy: the compiler has to assume that pixels are written over what it reads.
struct TexelRows {
    const std::uint8_t* texels;
    std::int32_t stride;
    int stride_log2;

    explicit TexelRows(const SurfaceView& surface)
        : texels(surface.texels), stride(1 << surface.stride_log2), stride_log2(surface.stride_log2) {}
};

[[gnu::always_inline]] inline void draw_within(const TexelBlock& block, const TexelRows& rows, std::uint8_t* out) {
    const auto u_step = static_cast<std::uint32_t>(block.u_step_16),
               v_step = static_cast<std::uint32_t>(block.v_step_16);
    const std::int32_t whole =
        floor_shift(block.v_step_16, 16) * (std::int32_t{1} << rows.stride_log2) + floor_shift(block.u_step_16, 16);
    const TexelWalk walk{u_step << 16, v_step << 16, {whole + rows.stride, whole}, out + (block.count & ~3)};
    TexelPlace place{rows.texels + ((block.v_16 >> 16 << rows.stride_log2) + (block.u_16 >> 16)), block.u_16 << 16,
                     block.v_16 << 16, out};
    if (block.count >= 4) place.draw_fours(walk);
    if (block.count & 2) place.draw_two(walk);
    if (block.count & 1) *place.out = *place.texel;
}

/// Whether a block stays within a surface. Apart, as most surfaces hold all blocks: the loop keeps its registers.
[[gnu::noinline]] bool is_within(const TexelBlock& block, const SurfaceView& surface) {
    const std::uint32_t beyond_u = ~(surface.u_mask << 16 | 0xffff), beyond_v = ~(surface.v_mask << 16 | 0xffff);
    const auto steps = static_cast<std::uint32_t>(block.count - 1);
    const std::uint32_t u_end = block.u_16 + static_cast<std::uint32_t>(block.u_step_16) * steps;
    const std::uint32_t v_end = block.v_16 + static_cast<std::uint32_t>(block.v_step_16) * steps;
    return (((block.u_16 | u_end) & beyond_u) | ((block.v_16 | v_end) & beyond_v)) == 0;
}

}  // namespace

void draw_blocks_by_fours(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    const TexelRows rows(surface);
    if (surface.holds_blocks) {
        for (const TexelBlock& block : blocks) draw_within(block, rows, pixels + block.pixel);
        return;
    }
    for (const TexelBlock& block : blocks)
        if (is_within(block, surface))
            draw_within(block, rows, pixels + block.pixel);
        else
            draw_any(block, surface, pixels);
}

#else

void draw_blocks_by_fours(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    draw_blocks_packed(blocks, surface, pixels);
}

#endif

}  // namespace oblong

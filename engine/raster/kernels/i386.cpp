#include <cstddef>

#include "engine/raster/kernels/packed.h"

namespace oblong {

#if defined(__i386__)

namespace {

/// A surface, and a walk along a block that stays within it.
struct TexelWalk {
    const std::uint8_t* texels;
    std::int32_t stride;
    int stride_log2;
    std::uint8_t* pixels;
    std::uint32_t u_fraction = 0, v_fraction = 0;  ///< of the steps, 0.32: sums carry into whole texels
    std::int32_t steps[2]{};            ///< whole steps as offsets in the surface: with a carry of v, and without
    const std::uint8_t* end = nullptr;  ///< of the pairs of pixels
    std::int32_t count = 0;

    TexelWalk(const SurfaceView& surface, std::uint8_t* first_pixel)
        : texels(surface.texels),
          stride(1 << surface.stride_log2),
          stride_log2(surface.stride_log2),
          pixels(first_pixel) {}
};

// To the next texel (ecx), in four instructions, three of them for the carries.
#define OBLONG_NEXT_TEXEL        \
    "addl 20(%[walk]), %[v]\n\t" \
    "sbbl %%eax, %%eax\n\t"      \
    "addl 16(%[walk]), %[u]\n\t" \
    "adcl 28(%[walk], %%eax, 4), %%ecx\n\t"
#define OBLONG_PIXEL(HALF) "movb (%%ecx), %%" HALF "\n\t" OBLONG_NEXT_TEXEL

/// In 32 instructions for a block, six a pixel; all registers are needed. Two pixels are written at once, and an odd
/// pair begins in the middle of the loop. Fractions are read with the two bytes before them: of u those are the upper
/// half of the count, 0, and of v they do not matter, as nothing is added to them.
[[gnu::always_inline]] inline void draw_within(const TexelBlock& block, TexelWalk& walk) {
    static_assert(offsetof(TexelBlock, count) == 4 && offsetof(TexelBlock, u_16) == 8 &&
                  offsetof(TexelBlock, v_16) == 12 && offsetof(TexelBlock, u_step_16) == 16 &&
                  offsetof(TexelBlock, v_step_16) == 20);
    static_assert(offsetof(TexelWalk, stride) == 4 && offsetof(TexelWalk, stride_log2) == 8 &&
                  offsetof(TexelWalk, pixels) == 12 && offsetof(TexelWalk, u_fraction) == 16 &&
                  offsetof(TexelWalk, v_fraction) == 20 && offsetof(TexelWalk, steps) == 24 &&
                  offsetof(TexelWalk, end) == 32 && offsetof(TexelWalk, count) == 36);
    const void* place = &block;  // then of the pixel
    std::uint32_t u, v;          // fractions, 0.32
    asm volatile(
        "movl 8(%[walk]), %%ecx\n\t"
        "movl 16(%[place]), %[u]\n\tshll $16, %[u]\n\tmovl %[u], 16(%[walk])\n\t"
        "movl 20(%[place]), %[v]\n\tshll $16, %[v]\n\tmovl %[v], 20(%[walk])\n\t"
        "movswl 22(%[place]), %%eax\n\tshll %%cl, %%eax\n\tmovswl 18(%[place]), %%edx\n\taddl %%edx, %%eax\n\t"
        "movl %%eax, 28(%[walk])\n\taddl 4(%[walk]), %%eax\n\tmovl %%eax, 24(%[walk])\n\t"
        "movzwl 14(%[place]), %%eax\n\tshll %%cl, %%eax\n\tmovzwl 10(%[place]), %%ecx\n\taddl %%eax, %%ecx\n\t"
        "addl (%[walk]), %%ecx\n\t"
        "movl 6(%[place]), %[u]\n\tmovl 10(%[place]), %[v]\n\t"
        "movl 4(%[place]), %%eax\n\tmovl %%eax, 36(%[walk])\n\t"
        "movl (%[place]), %[place]\n\taddl 12(%[walk]), %[place]\n\t"
        "movl %%eax, %%edx\n\tandl $-2, %%edx\n\tjz 2f\n\t"
        "addl %[place], %%edx\n\tmovl %%edx, 32(%[walk])\n\t"
        "testb $2, %%al\n\tjz 0f\n\tsubl $2, %[place]\n\tjmp 1f\n"
        "0:\n\t" OBLONG_PIXEL("dl") OBLONG_PIXEL("dh") "movw %%dx, (%[place])\n"
        "1:\n\t" OBLONG_PIXEL("dl") OBLONG_PIXEL("dh") "movw %%dx, 2(%[place])\n\t"
        "addl $4, %[place]\n\tcmpl 32(%[walk]), %[place]\n\tjne 0b\n"
        "2:\n\ttestb $1, 36(%[walk])\n\tjz 3f\n\tmovb (%%ecx), %%al\n\tmovb %%al, (%[place])\n"
        "3:"
        : [place] "+&r"(place), [u] "=&r"(u), [v] "=&r"(v)
        : [walk] "r"(&walk)
        : "eax", "ecx", "edx", "cc", "memory");
}

/// Any block; a function of its own, for the sake of the other's registers.
[[gnu::noinline]] void draw_any(const TexelBlock& block, const SurfaceView& surface, std::uint8_t* pixels) {
    draw_packed_block(block, pixels, PackedFetch(surface));
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

void draw_blocks_i386(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    TexelWalk walk(surface, pixels);
    if (surface.holds_blocks) {
        for (const TexelBlock& block : blocks) draw_within(block, walk);
        return;
    }
    for (const TexelBlock& block : blocks)
        if (is_within(block, surface))
            draw_within(block, walk);
        else
            draw_any(block, surface, pixels);
}

#endif

}  // namespace oblong

#include <bit>
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

#endif

}  // namespace oblong

#pragma once

#include <cstdint>

#include "engine/raster/kernels/kernels.h"

namespace oblong {

template <class Fetch>
[[gnu::always_inline]] inline void draw_four(std::uint64_t vu, std::uint64_t step, std::uint8_t* out, Fetch fetch) {
    out[0] = fetch(vu);
    out[1] = fetch(vu + step);
    out[2] = fetch(vu + 2 * step);
    out[3] = fetch(vu + 3 * step);
}

template <class Fetch>
[[gnu::always_inline]] inline void draw_eight(std::uint64_t vu, std::uint64_t step, std::uint8_t* out, Fetch fetch) {
    draw_four(vu, step, out, fetch);
    draw_four(vu + 4 * step, step, out + 4, fetch);
}

/// The loop of the packed kernels. v is in the upper and u in the lower half of one word; since both stay in [0,
/// 65,535] texels, no carry crosses. `fetch` maps the word to a texel. The last pixels may overlap those before: a loop
/// over the remainder would often be mispredicted, which takes longer.
template <class Fetch>
[[gnu::always_inline]] inline void draw_packed_block(const TexelBlock& block, std::uint8_t* pixels, Fetch fetch) {
    const std::uint64_t first = std::uint64_t{block.v_16} << 32 | block.u_16;
    const std::uint64_t step = (static_cast<std::uint64_t>(std::int64_t{block.v_step_16}) << 32) +
                               static_cast<std::uint64_t>(std::int64_t{block.u_step_16});
    const auto count = static_cast<std::uint32_t>(block.count);
    std::uint8_t* const begin = pixels + block.pixel;
    if (count < 4) {
        begin[0] = fetch(first);
        begin[count / 2] = fetch(first + count / 2 * step);
        begin[count - 1] = fetch(first + (count - 1) * step);
        return;
    }
    if (count < 8) {
        draw_four(first, step, begin, fetch);
        draw_four(first + (count - 4) * step, step, begin + (count - 4), fetch);
        return;
    }
    std::uint8_t* const last = begin + (count - 8);
    std::uint64_t vu = first;
    for (std::uint8_t* out = begin; out < last; out += 8, vu += 8 * step) draw_eight(vu, step, out, fetch);
    draw_eight(first + (count - 8) * step, step, last, fetch);
}

/// Computes the texel's offset with shifts and masks.
struct PackedFetch {
    std::uint64_t u_mask, row_mask;
    int row_shift;
    const std::uint8_t* texels;

    explicit PackedFetch(const SurfaceView& surface)
        : u_mask(surface.u_mask),
          row_mask(std::uint64_t{surface.v_mask} << surface.stride_log2),
          row_shift(48 - surface.stride_log2),
          texels(surface.texels) {}

    std::uint8_t operator()(std::uint64_t vu) const {
        return texels[((vu >> row_shift) & row_mask) | ((vu >> 16) & u_mask)];
    }
};

#if defined(__x86_64__)

/// One `pext`, without enabling BMI2 for the compiler elsewhere.
[[gnu::always_inline]] inline std::uint64_t extracted(std::uint64_t from, std::uint64_t mask) {
    std::uint64_t bits;
    asm("pext %2, %1, %0" : "=r"(bits) : "r"(from), "r"(mask));
    return bits;
}

/// Extracts the texel's offset from the word with `pext`.
struct Bmi2Fetch {
    std::uint64_t offset_mask;
    const std::uint8_t* texels;

    explicit Bmi2Fetch(const SurfaceView& surface)
        : offset_mask(std::uint64_t{surface.v_mask} << 48 | std::uint64_t{surface.u_mask} << 16),
          texels(surface.texels) {}

    [[gnu::always_inline]] std::uint8_t operator()(std::uint64_t vu) const {
        return texels[extracted(vu, offset_mask)];
    }
};

#endif

}  // namespace oblong

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "engine/raster/kernels/kernels.h"

namespace oblong {

/// Consecutive pixels, each stored as it is fetched.
struct PixelStores {
    std::uint8_t* out;

    template <int kPlace>
    [[gnu::always_inline]] void put(const std::uint8_t& texel) {
        out[kPlace] = texel;
    }
    template <int kCount>
    [[gnu::always_inline]] void finish() const {}
};

template <int kFirst, class Pixels, class Fetch>
[[gnu::always_inline]] inline void put_four(Pixels& pixels, std::uint64_t vu, std::uint64_t step, const Fetch& fetch) {
    pixels.template put<kFirst>(fetch(vu));
    pixels.template put<kFirst + 1>(fetch(vu + step));
    pixels.template put<kFirst + 2>(fetch(vu + 2 * step));
    pixels.template put<kFirst + 3>(fetch(vu + 3 * step));
}

template <class Fetch>
[[gnu::always_inline]] inline void draw_four(std::uint64_t vu, std::uint64_t step, std::uint8_t* out,
                                             const Fetch& fetch) {
    typename Fetch::Pixels pixels{out};
    put_four<0>(pixels, vu, step, fetch);
    pixels.template finish<4>();
}

template <class Fetch>
[[gnu::always_inline]] inline void draw_eight(std::uint64_t vu, std::uint64_t step, std::uint8_t* out,
                                              const Fetch& fetch) {
    typename Fetch::Pixels pixels{out};
    put_four<0>(pixels, vu, step, fetch);
    put_four<4>(pixels, vu + 4 * step, step, fetch);
    pixels.template finish<8>();
}

/// The loop of the packed kernels. v is in the upper and u in the lower half of one word; since both stay in [0,
/// 65,535] texels, no carry crosses. `fetch` maps the word to a texel. Some pixels may be drawn twice: a loop over the
/// remainder would often be mispredicted, which takes longer.
template <class Fetch>
[[gnu::always_inline]] inline void draw_packed_block(const TexelBlock& block, std::uint8_t* pixels, Fetch fetch) {
    const std::uint64_t first = std::uint64_t{block.v_16} << 32 | block.u_16;
    const std::uint64_t step = (static_cast<std::uint64_t>(std::int64_t{block.v_step_16}) << 32) +
                               static_cast<std::uint64_t>(std::int64_t{block.u_step_16});
    const std::ptrdiff_t count = block.count;
    const auto vu_at = [&](std::ptrdiff_t place) { return first + static_cast<std::size_t>(place) * step; };
    std::uint8_t* const begin = pixels + block.pixel;
    if (count >= 8) {
        draw_eight(first, step, begin, fetch);
        std::uint64_t vu = vu_at(count - 8);
        // From the right. `before` is one less than the pixels to the left of the eight: it is compared with 0, for
        // which the subtraction has set the processor's flags.
        for (std::ptrdiff_t before = count - 9; before >= 0; before -= 8, vu -= 8 * step)
            draw_eight(vu, step, begin + (before + 1), fetch);
    } else if (count >= 4) {
        draw_four(first, step, begin, fetch);
        draw_four(vu_at(count - 4), step, begin + (count - 4), fetch);
    } else {
        const std::ptrdiff_t middle = count >> 1;
        begin[0] = fetch(first);
        begin[middle] = fetch(vu_at(middle));
        begin[count - 1] = fetch(vu_at(count - 1));
    }
}

/// Computes the texel's offset with shifts and masks.
struct PackedFetch {
    using Pixels = PixelStores;

    std::uint64_t u_mask, row_mask;
    int row_shift;
    const std::uint8_t* texels;

    explicit PackedFetch(const SurfaceView& surface)
        : u_mask(surface.u_mask),
          row_mask(std::uint64_t{surface.v_mask} << surface.stride_log2),
          row_shift(48 - surface.stride_log2),
          texels(surface.texels) {}

    const std::uint8_t& operator()(std::uint64_t vu) const {
        return texels[((vu >> row_shift) & row_mask) | ((vu >> 16) & u_mask)];
    }
};

}  // namespace oblong

#pragma once

#include <cstdint>
#include <span>

#include "engine/raster/kernels/kernels.h"

namespace oblong {

/// The loop that the packed kernels share. v lies in the upper and u in the lower half of one word; since neither
/// leaves [0, 65,535] texels on the way, no carry crosses. `fetch` turns the word into a texel.
template <class Fetch>
[[gnu::always_inline]] inline void draw_packed_blocks(std::span<const TexelBlock> blocks, std::uint8_t* pixels,
                                                      Fetch fetch) {
    for (const TexelBlock& block : blocks) {
        std::uint64_t vu = std::uint64_t{block.v_16} << 32 | block.u_16;
        const std::uint64_t step = (static_cast<std::uint64_t>(std::int64_t{block.v_step_16}) << 32) +
                                   static_cast<std::uint64_t>(std::int64_t{block.u_step_16});
        std::uint8_t* out = pixels + block.pixel;
        std::uint8_t* const end = out + block.count;
        for (; end - out >= 4; out += 4) {
            out[0] = fetch(vu);
            out[1] = fetch(vu + step);
            out[2] = fetch(vu + 2 * step);
            out[3] = fetch(vu + 3 * step);
            vu += 4 * step;
        }
        for (; out != end; ++out, vu += step) *out = fetch(vu);
    }
}

}  // namespace oblong

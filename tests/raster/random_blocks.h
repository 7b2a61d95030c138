#pragma once

#include <algorithm>
#include <vector>

#include "engine/raster/kernels/kernels.h"
#include "tests/support/random.h"

namespace oblong::test {

constexpr std::int32_t kLongestBlock = 600;

/// A block whose coordinates stay within [0, 65,535] texels on the way, as the span cutter makes them.
inline TexelBlock random_block(std::mt19937& random, std::uint32_t pixel) {
    const auto longest = static_cast<std::uint32_t>(random() % 4 ? 64 : kLongestBlock);
    const auto count = static_cast<std::int32_t>(1 + random() % longest);
    const auto coordinate = [&] { return static_cast<std::uint32_t>(random() % 0xffff0000u); };
    const std::uint32_t u = coordinate(), v = coordinate();
    const auto step = [&](std::uint32_t from) {
        const std::int64_t to = coordinate();
        const std::int64_t whole = (to - from) / (random() % 2 ? 1 : 1 << 12);
        return static_cast<std::int32_t>(whole / count);
    };
    return {pixel, count, u, v, step(u), step(v)};
}

/// Blocks in any order, pixels that belong to none of them between: a kernel that writes beyond a block shows.
inline std::vector<TexelBlock> random_blocks(std::mt19937& random, std::uint32_t& pixel_count) {
    std::vector<TexelBlock> blocks;
    for (pixel_count = 0; pixel_count < 5000; pixel_count += static_cast<std::uint32_t>(random() % 3)) {
        blocks.push_back(random_block(random, pixel_count));
        pixel_count += static_cast<std::uint32_t>(blocks.back().count);
    }
    std::shuffle(blocks.begin(), blocks.end(), random);
    return blocks;
}

}  // namespace oblong::test

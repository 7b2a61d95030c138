#pragma once

#include <array>
#include <cstdint>

#include "engine/view/screen.h"

namespace oblong {

/// A triangle's three edge functions along a row of pixels: at the first one, and their step to the next. A pixel is
/// inside where none of them is below 0.
struct EdgeRow {
    std::array<std::int64_t, 3> value, step;
};

/// Which of a row's first `count` pixels are inside: consecutive ones, since a triangle is convex.
using EdgeRowKernel = PixelRange (*)(const EdgeRow& row, std::int32_t count);

/// The reference implementation: a pixel at a time.
PixelRange inside_edges_plain(const EdgeRow& row, std::int32_t count);
/// SSE2, eight pixels at a time (plain where the processor has none). Only where all values that belong to the pixels
/// fit 32 bits.
PixelRange inside_edges_sse2(const EdgeRow& row, std::int32_t count);

}  // namespace oblong

#pragma once

#include <cstdint>

#include "engine/raster/kernels/kernels.h"

namespace oblong {

/// A bit for each pixel of a block of up to 64 (its first is the lowest) whose u or v is nearer than `error_16` units
/// of 2^-16 to a whole texel: at most that much behind it, or less before it. The error is below a quarter of a texel.
using BorderKernel = std::uint64_t (*)(const TexelBlock& block, std::uint32_t error_16);

/// The reference implementation: a pixel at a time.
std::uint64_t pixels_near_borders_plain(const TexelBlock& block, std::uint32_t error_16);
/// SSE2, eight pixels at a time (plain where the processor has none).
std::uint64_t pixels_near_borders(const TexelBlock& block, std::uint32_t error_16);

}  // namespace oblong

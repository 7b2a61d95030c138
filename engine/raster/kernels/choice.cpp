#include <array>

#include "engine/raster/kernels/kernels.h"

namespace oblong {

namespace {

constexpr std::array<NamedKernel, 5> kBlockKernels{{{"avx2", draw_blocks_avx2},
                                                    {"bmi2", draw_blocks_bmi2},
                                                    {"fours", draw_blocks_by_fours},
                                                    {"packed", draw_blocks_packed},
                                                    {"plain", draw_blocks_plain}}};

}  // namespace

std::span<const NamedKernel> block_kernels() {
    const std::size_t first = has_avx2() ? 0 : has_bmi2() ? 1 : 2;
    return std::span(kBlockKernels).subspan(first);
}

BlockKernel best_block_kernel() {
    return block_kernels().front().draw;
}

}  // namespace oblong

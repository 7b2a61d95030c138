#include <array>

#include "engine/raster/kernels/kernels.h"

namespace oblong {

namespace {

constexpr std::array<NamedKernel, 4> kBlockKernels{{{"bmi2", draw_blocks_bmi2},
                                                    {"fours", draw_blocks_by_fours},
                                                    {"packed", draw_blocks_packed},
                                                    {"plain", draw_blocks_plain}}};

}  // namespace

Instructions best_instructions() {
    return has_bmi2() ? Instructions::Bmi2 : Instructions::Baseline;
}

std::span<const NamedKernel> block_kernels() {
    return std::span(kBlockKernels).subspan(has_bmi2() ? 0 : 1);
}

BlockKernel best_block_kernel() {
    return block_kernels().front().draw;
}

}  // namespace oblong

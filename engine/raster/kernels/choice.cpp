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
#if defined(__x86_64__)
    const bool has_avx512 =
        __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq");
    if (has_bmi2()) return has_avx512 ? Instructions::Avx512 : Instructions::Bmi2;
#endif
    return Instructions::Baseline;
}

std::span<const NamedKernel> block_kernels() {
    return std::span(kBlockKernels).subspan(has_bmi2() ? 0 : 1);
}

BlockKernel best_block_kernel() {
    return block_kernels().front().draw;
}

}  // namespace oblong

#include <string_view>

#include "engine/raster/kernels/kernels.h"
#include "engine/raster/kernels/native_kernels.h"

namespace oblong {

namespace {

constexpr Kernels kPlain{"plain", draw_blocks_plain, pixels_near_borders_plain, inside_edges_plain, nullptr, nullptr,
                         nullptr};

#if defined(__x86_64__) && defined(__SSE2__)
constexpr Kernels kBaseline{
    "baseline", draw_blocks_by_fours, pixels_near_borders_sse2, inside_edges_sse2, light_cells_sse2, nullptr, nullptr};
constexpr std::array kKernels{Kernels{"bmi2", draw_blocks_bmi2, pixels_near_borders_sse2, inside_edges_sse2,
                                      light_cells_sse2, draw_warped_blocks_bmi2, cut_bounded_bmi2},
                              kBaseline, kPlain};
#else
#if defined(__i386__)
constexpr BlockKernel kBlocks = draw_blocks_i386;
#elif defined(__ARM_NEON) || defined(__ALTIVEC__)
constexpr BlockKernel kBlocks = draw_blocks_by_fours;
#else
constexpr BlockKernel kBlocks = draw_blocks_packed;
#endif
constexpr std::array kKernels{
    Kernels{"baseline", kBlocks, pixels_near_borders_plain, inside_edges_plain, nullptr, nullptr, nullptr}, kPlain};
#endif

/// Whether the first of the kernels can run.
bool has_best() {
#if defined(__x86_64__) && defined(__SSE2__)
    // On AMD's Zen 1 and 2 `pext` is microcoded and slower than shifts and masks.
    return __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("avx") && !__builtin_cpu_is("znver1") &&
           !__builtin_cpu_is("znver2");
#else
    return true;
#endif
}

}  // namespace

std::span<const Kernels> all_kernels() {
    return std::span(kKernels).subspan(has_best() ? 0 : 1);
}

const Kernels* find_kernels(std::string_view name) {
    for (const Kernels& kernels : all_kernels())
        if (kernels.name == name) return &kernels;
    return nullptr;
}

}  // namespace oblong

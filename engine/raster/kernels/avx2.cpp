#include "engine/raster/kernels/avx2_texels.h"
#include "engine/raster/kernels/packed.h"

namespace oblong {

#if defined(__x86_64__) && defined(__SSE2__)

namespace {

/// Shorter blocks take less time by draw_packed_block: a gather saves instructions, but no accesses to memory.
constexpr std::int32_t kLeastGathered = 32;

}  // namespace

bool has_avx2() {
    return __builtin_cpu_supports("avx2") && has_bmi2();
}

[[OBLONG_AVX2]] void draw_blocks_avx2(std::span<const TexelBlock> blocks, const SurfaceView& surface,
                                      std::uint8_t* pixels) {
    if (!EightTexels::can_draw(surface)) return draw_blocks_bmi2(blocks, surface, pixels);
    const EightTexels texels(surface);
    const Bmi2Fetch fetch(surface);
    for (const TexelBlock& block : blocks) {
        if (block.count < kLeastGathered)
            draw_packed_block(block, pixels, fetch);
        else
            draw_by_sixteens(block, texels, pixels + block.pixel);
    }
}

#else

bool has_avx2() {
    return false;
}

void draw_blocks_avx2(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    draw_blocks_packed(blocks, surface, pixels);
}

#endif

}  // namespace oblong

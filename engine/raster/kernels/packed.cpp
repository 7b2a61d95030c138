#include "engine/raster/kernels/packed.h"

namespace oblong {

void draw_blocks_packed(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    const PackedFetch fetch(surface);
    for (const TexelBlock& block : blocks) draw_packed_block(block, pixels, fetch);
}

#if defined(__x86_64__)

bool has_bmi2() {
    // On AMD's Zen 1 and 2 `pext` is microcoded and slower than shifts and masks.
    return __builtin_cpu_supports("bmi2") && !__builtin_cpu_is("znver1") && !__builtin_cpu_is("znver2");
}

void draw_blocks_bmi2(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    const Bmi2Fetch fetch(surface);
    for (const TexelBlock& block : blocks) draw_packed_block(block, pixels, fetch);
}

#else

bool has_bmi2() {
    return false;
}

void draw_blocks_bmi2(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    draw_blocks_packed(blocks, surface, pixels);
}

#endif

}  // namespace oblong

#include "engine/raster/kernels/kernels.h"
#include "engine/raster/kernels/packed.h"

namespace oblong {

#if defined(__x86_64__)

bool has_bmi2() {
    return __builtin_cpu_supports("bmi2");
}

void draw_blocks_bmi2(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    const std::uint64_t offset_mask = std::uint64_t{surface.v_mask} << 48 | std::uint64_t{surface.u_mask} << 16;
    const std::uint8_t* const texels = surface.texels;
    draw_packed_blocks(blocks, pixels, [=](std::uint64_t vu) {
        std::uint64_t offset;  // _pext_u64, without asking the compiler for BMI2 anywhere else
        asm("pext %2, %1, %0" : "=r"(offset) : "r"(vu), "r"(offset_mask));
        return texels[offset];
    });
}

#else

bool has_bmi2() {
    return false;
}

void draw_blocks_bmi2(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    draw_blocks_packed(blocks, surface, pixels);
}

#endif

BlockKernel best_block_kernel() {
    return has_bmi2() ? draw_blocks_bmi2 : draw_blocks_packed;
}

}  // namespace oblong

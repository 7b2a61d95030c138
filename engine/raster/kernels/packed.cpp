#include "engine/raster/kernels/packed.h"

#include "engine/raster/kernels/kernels.h"

namespace oblong {

void draw_blocks_packed(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    const std::uint64_t u_mask = surface.u_mask;
    const std::uint64_t row_mask = std::uint64_t{surface.v_mask} << surface.stride_log2;
    const int row_shift = 48 - surface.stride_log2;
    const std::uint8_t* const texels = surface.texels;
    draw_packed_blocks(blocks, pixels, [=](std::uint64_t vu) {
        return texels[((vu >> row_shift) & row_mask) | ((vu >> 16) & u_mask)];
    });
}

}  // namespace oblong

#include "engine/raster/kernels/kernels.h"

namespace oblong {

void draw_blocks_plain(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    for (const TexelBlock& block : blocks) {
        std::uint32_t u = block.u_16, v = block.v_16;
        for (std::int32_t i = 0; i < block.count; ++i) {
            const std::uint32_t column = (u >> 16) & surface.u_mask, row = (v >> 16) & surface.v_mask;
            pixels[block.pixel + static_cast<std::uint32_t>(i)] = surface.texels[(row << surface.stride_log2) + column];
            u += static_cast<std::uint32_t>(block.u_step_16);
            v += static_cast<std::uint32_t>(block.v_step_16);
        }
    }
}

void draw_blocks_any_size(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    const auto width = static_cast<std::uint32_t>(surface.width), height = static_cast<std::uint32_t>(surface.height);
    for (const TexelBlock& block : blocks) {
        std::uint32_t u = block.u_16, v = block.v_16;
        for (std::int32_t i = 0; i < block.count; ++i) {
            pixels[block.pixel + static_cast<std::uint32_t>(i)] =
                surface.texels[(v >> 16) % height * width + (u >> 16) % width];
            u += static_cast<std::uint32_t>(block.u_step_16);
            v += static_cast<std::uint32_t>(block.v_step_16);
        }
    }
}

}  // namespace oblong

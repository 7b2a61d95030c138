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

namespace {

/// Moved up by the error, a coordinate near a whole texel has a fraction below twice the error.
bool is_near_whole(std::uint32_t texel_16, std::uint32_t error_16) {
    return ((texel_16 + error_16) & 0xffff) < 2 * error_16;
}

}  // namespace

std::uint64_t pixels_near_borders_plain(const TexelBlock& block, std::uint32_t error_16) {
    std::uint64_t near = 0;
    std::uint32_t u_16 = block.u_16, v_16 = block.v_16;
    for (std::int32_t i = 0; i < block.count; ++i) {
        near |= std::uint64_t{is_near_whole(u_16, error_16) || is_near_whole(v_16, error_16)} << i;
        u_16 += static_cast<std::uint32_t>(block.u_step_16);
        v_16 += static_cast<std::uint32_t>(block.v_step_16);
    }
    return near;
}

PixelRange inside_edges_plain(const EdgeRow& row, std::int32_t count) {
    auto [a, b, c] = row.value;
    PixelRange inside{count, count};
    for (std::int32_t column = 0; column < count; ++column) {
        const bool is_inside = (a | b | c) >= 0;
        if (is_inside && inside.first == count) inside.first = column;
        if (!is_inside && inside.first < count) {
            inside.end = column;
            break;
        }
        a += row.step[0];
        b += row.step[1];
        c += row.step[2];
    }
    return inside;
}

}  // namespace oblong

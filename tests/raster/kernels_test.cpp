// Every kernel writes the bytes that draw_blocks_plain writes, which are those of the definition.

#include "engine/raster/kernels/kernels.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace oblong::test {

namespace {

struct RandomSurface {
    std::vector<std::uint8_t> texels;
    SurfaceView view;

    RandomSurface(std::mt19937& random, int width_log2, int height_log2) {
        view.width = 1 << width_log2;
        view.height = 1 << height_log2;
        view.stride_log2 = width_log2;
        view.u_mask = static_cast<std::uint32_t>(view.width) - 1;
        view.v_mask = static_cast<std::uint32_t>(view.height) - 1;
        texels.resize(std::size_t{1} << (width_log2 + height_log2));
        for (std::uint8_t& texel : texels) texel = static_cast<std::uint8_t>(random());
        view.texels = texels.data();
    }
};

/// A block whose coordinates stay within [0, 65,535] texels on the way, as the span cutter makes them.
TexelBlock random_block(std::mt19937& random, std::uint32_t pixel) {
    const auto count = static_cast<std::int32_t>(1 + random() % 64);
    const auto coordinate = [&] { return static_cast<std::uint32_t>(random() % 0xffff0000u); };
    const std::uint32_t u = coordinate(), v = coordinate();
    const auto step = [&](std::uint32_t from) {
        const std::int64_t to = coordinate();
        const std::int64_t whole = (to - from) / (random() % 2 ? 1 : 1 << 12);
        return static_cast<std::int32_t>(whole / count);
    };
    return {pixel, count, u, v, step(u), step(v)};
}

std::vector<TexelBlock> random_blocks(std::mt19937& random, std::uint32_t& pixel_count) {
    std::vector<TexelBlock> blocks;
    for (pixel_count = 0; pixel_count < 5000;) {
        blocks.push_back(random_block(random, pixel_count));
        pixel_count += static_cast<std::uint32_t>(blocks.back().count);
    }
    return blocks;
}

std::vector<std::uint8_t> drawn(BlockKernel kernel, const std::vector<TexelBlock>& blocks, const SurfaceView& surface,
                                std::uint32_t pixel_count) {
    std::vector<std::uint8_t> pixels(pixel_count + 16, 0xa5);  // what lies behind the last block must stay
    kernel(blocks, surface, pixels.data());
    return pixels;
}

/// The definition, in 64-bit arithmetic: the texel at floor(u), floor(v), wrapped by division.
std::vector<std::uint8_t> defined(const std::vector<TexelBlock>& blocks, const SurfaceView& surface,
                                  std::int64_t stride, std::uint32_t pixel_count) {
    std::vector<std::uint8_t> pixels(pixel_count + 16, 0xa5);
    for (const TexelBlock& block : blocks)
        for (std::int64_t i = 0; i < block.count; ++i) {
            const std::int64_t u = (block.u_16 + i * block.u_step_16) / 65536 % surface.width;
            const std::int64_t v = (block.v_16 + i * block.v_step_16) / 65536 % surface.height;
            pixels[block.pixel + static_cast<std::size_t>(i)] = surface.texels[v * stride + u];
        }
    return pixels;
}

}  // namespace

TEST(Kernels, AllWriteTheDefinition) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const RandomSurface surface(random, static_cast<int>(random() % 10), static_cast<int>(random() % 10));
        std::uint32_t pixel_count = 0;
        const std::vector<TexelBlock> blocks = random_blocks(random, pixel_count);
        const auto expected = defined(blocks, surface.view, surface.view.width, pixel_count);
        ASSERT_EQ(drawn(draw_blocks_plain, blocks, surface.view, pixel_count), expected);
        ASSERT_EQ(drawn(draw_blocks_packed, blocks, surface.view, pixel_count), expected);
        ASSERT_EQ(drawn(draw_blocks_any_size, blocks, surface.view, pixel_count), expected);
        if (has_bmi2()) {
            ASSERT_EQ(drawn(draw_blocks_bmi2, blocks, surface.view, pixel_count), expected);
        }
        ASSERT_EQ(drawn(best_block_kernel(), blocks, surface.view, pixel_count), expected);
    }
}

TEST(Kernels, HardCaseX8_SizesThatAreNoPowersOfTwo) {
    std::mt19937 random(2);
    for (const auto& [width, height] : {std::pair{300, 7}, {48, 80}, {1, 1}, {513, 3}}) {
        std::vector<std::uint8_t> texels(static_cast<std::size_t>(width * height));
        for (std::uint8_t& texel : texels) texel = static_cast<std::uint8_t>(random());
        SurfaceView surface;
        surface.texels = texels.data();
        surface.width = width;
        surface.height = height;
        std::uint32_t pixel_count = 0;
        const std::vector<TexelBlock> blocks = random_blocks(random, pixel_count);
        EXPECT_EQ(drawn(draw_blocks_any_size, blocks, surface, pixel_count),
                  defined(blocks, surface, width, pixel_count));
    }
}

}  // namespace oblong::test

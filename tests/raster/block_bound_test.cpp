// The bound on texture error is proved in block_rule.h; here it is held against doubles: whatever texel a block
// shows at a pixel belongs, on the true plane, no farther from that pixel than the dial says.

#include <gtest/gtest.h>

#include "engine/raster/texture_blocks.h"
#include "tests/support/random.h"

namespace oblong::test {

namespace {

constexpr std::int32_t kWidth = 320;

/// One row of a plane whose z goes from z0 at column 0 to z1 at column 320 and whose u from 0 to `texels`.
TextureGradients row_of(double z0, double z1, double texels) {
    const double w0 = 1 / z0, w1 = 1 / z1;
    TextureGradients row;
    row.inverse_z = {fixed_of<InverseZ>(w0), fixed_of<InverseZ>((w1 - w0) / kWidth), {}};
    row.u_over_z = {{}, fixed_of<TexelOverZ>(texels * w1 / kWidth), {}};
    row.v_over_z = row.u_over_z;
    return row;
}

TextureGradients random_row(std::mt19937& random) {
    const double z0 = std::exp2(random_between(random, 2, 14)), z1 = std::exp2(random_between(random, 2, 14));
    return row_of(z0, z1, 60000);
}

/// Where on the row the true plane shows texel u: the inverse of u = (a x) / (w + b x), all of it as drawn.
double column_of_texel(const TextureGradients& row, double u) {
    const double a = number_of(row.u_over_z.per_column), w = number_of(row.inverse_z.origin),
                 b = number_of(row.inverse_z.per_column);
    return u * w / (a - u * b);
}

constexpr std::array kRow{Span{0, 0, kWidth}};
const TexelLimits kNoLimits = make_texel_limits(65535, 65535, 0);

Accuracy bounded(std::int32_t pixel_bound_256) {
    Accuracy accuracy;
    accuracy.pixel_bound_256 = pixel_bound_256;
    return accuracy;
}

BlockList blocks_of(const TextureGradients& row, const Accuracy& accuracy, const TexelLimits& limits = kNoLimits) {
    const BlockRule rule = make_block_rule(accuracy);
    const BlockThresholds thresholds = make_block_thresholds(rule, row.inverse_z.per_column);
    BlockList blocks(kWidth);
    block_cutter(accuracy)(kRow, kWidth, {row, limits, thresholds, rule.texel_bound_256}, blocks);
    return blocks;
}

/// The largest error at any pixel of the blocks, by what one is: of (column, the u shown there).
double largest_error(const BlockList& blocks, auto error_at) {
    double largest = 0;
    for (const TexelBlock& block : blocks.waiting())
        for (std::int32_t i = 0; i < block.count; ++i)
            largest = std::max(largest, std::abs(error_at(static_cast<std::int32_t>(block.pixel) + i,
                                                          (block.u_16 + double(i) * block.u_step_16) / 65536)));
    return largest;
}

double error_px(const TextureGradients& row, const Accuracy& accuracy, const TexelLimits& limits = kNoLimits) {
    return largest_error(blocks_of(row, accuracy, limits),
                         [&](std::int32_t column, double u) { return column_of_texel(row, u) - column; });
}

}  // namespace

TEST(BlockBound, ErrorOnScreenStaysUnderTheDial) {
    std::mt19937 random(3);
    double largest_part = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const std::int32_t bound_256 = 8 << random() % 8;  // 1/32 to 4 pixels
        const double bound = bound_256 / 256.0;
        // Many texels a pixel, so that the 16.16 of texel coordinates is no part of the error: 1/1,000 pixel is left
        // for it.
        const double error = error_px(random_row(random), bounded(bound_256));
        ASSERT_LE(error, bound + 0.001) << trial << ", bound " << bound;
        largest_part = std::max(largest_part, error / bound);
    }
    EXPECT_GT(largest_part, 0.9) << "the bound is never nearly reached: blocks are shorter than they need be";
}

TEST(BlockBound, HoldsToTheLastPixelOfASurfaceThatEndsThere) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 4000; ++trial) {
        const TextureGradients row = random_row(random);
        const std::uint32_t last_16 = texel_at(row, kNoLimits, kWidth - 1, 0).u_16;
        const TexelLimits limits = make_texel_limits(static_cast<std::int32_t>(last_16 >> 16) + 1, 65535, 0);
        const Accuracy accuracy;
        ASSERT_LE(error_px(row, accuracy, limits), accuracy.pixel_bound_256 / 256.0 + 0.001) << trial;
    }
}

TEST(BlockBound, ErrorOnTheTextureStaysUnderItsDialAndComesNearIt) {
    std::mt19937 random(6);
    for (const std::int32_t bound_256 : {16, 64, 256, 1024}) {
        Accuracy accuracy;
        accuracy.texturing = Texturing::BoundedTexels;
        accuracy.texel_bound_256 = bound_256;
        double largest = 0;
        for (int trial = 0; trial < 500; ++trial) {
            const TextureGradients row = random_row(random);
            const auto error_at = [&](std::int32_t x, double u) {
                return u - number_of(row.u_over_z.at(x, 0)) / number_of(row.inverse_z.at(x, 0));
            };
            largest = std::max(largest, largest_error(blocks_of(row, accuracy), error_at));
        }
        EXPECT_LE(largest, bound_256 / 256.0 + 0.001);  // a depth right to 2^-26
        EXPECT_GT(largest, 0.9 * bound_256 / 256.0);
    }
}

TEST(BlockBound, CoarserDialsTakeFewerBlocks) {
    const TextureGradients wall = row_of(16, 1600, 4000);
    std::size_t before = kWidth + 1;
    for (const std::int32_t error : {4, 24, 96, 512, 4096}) {
        const std::size_t blocks = blocks_of(wall, bounded(error)).waiting().size();
        EXPECT_LT(blocks, before) << error;
        before = blocks;
    }
}

TEST(BlockBound, FacedSquarelyIsOneDivision) {
    const TextureGradients floor_row = row_of(100, 100, 500);
    const BlockList blocks = blocks_of(floor_row, {});
    EXPECT_EQ(divisions_of(kRow, {floor_row, kNoLimits, make_block_thresholds(make_block_rule({}), {})}, blocks), 1);
    EXPECT_EQ(blocks.waiting().size(), 1u);
}

TEST(BlockBound, ExactIsAsExactAsItsFormats) {
    std::mt19937 random(4);
    for (int trial = 0; trial < 300; ++trial) {
        const TextureGradients row = random_row(random);
        for (std::int32_t x = 0; x < kWidth; ++x) {
            const double u_over_z = number_of(row.u_over_z.at(x, 0));
            const double z = 1 / number_of(row.inverse_z.at(x, 0));
            // A depth right to 2^-26, and a step of 16.16.
            ASSERT_NEAR(texel_at(row, kNoLimits, x, 0).u_16 / 65536.0, u_over_z * z, 60000 * 0x1p-26 + 0x1p-16);
        }
    }
}

}  // namespace oblong::test

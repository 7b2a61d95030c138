#include <gtest/gtest.h>

#include <algorithm>

#include "engine/methods/triangles.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/raster/scan.h"
#include "engine/raster/texture_blocks.h"
#include "tests/hard_cases/hard_case.h"
#include "tests/support/reference_polygons.h"

namespace oblong::test {
namespace {

using reference::TexturedCorner;
using Corners = std::array<TexturedCorner, 3>;

constexpr std::array kModes{Texturing::Affine, Texturing::Every16, Texturing::Bounded, Texturing::Exact};

std::string texspan_fields(const Corners& corners, int row, int first, int end) {
    std::string line = "320 200 4 3 90";
    for (const TexturedCorner& corner : corners)
        line += " " + join(corner.position.x, corner.position.y, corner.position.z, corner.u, corner.v);
    return line + " " + join(row, first, end);
}

/// The largest error over a span, texels, of the mode called `name`.
double span_error(const std::string& name, const Corners& corners, int row, int first, int end) {
    const auto found = ask_numbers("texspanq " + name + " " + texspan_fields(corners, row, first, end));
    EXPECT_EQ(found.size(), static_cast<std::size_t>(end - first) * 2);
    double worst = 0;
    for (int column = first; column < end; ++column) {
        const auto expected = texel_at(corners, kProjection, {column + 0.5, row + 0.5});
        const auto at = static_cast<std::size_t>(column - first) * 2;
        worst = std::max({worst, std::abs(found.at(at) - expected.u), std::abs(found.at(at + 1) - expected.v)});
    }
    return worst;
}

/// A wall of which one row shows depths from 4 to 4,000, and 20,000 texels.
Corners receding_wall() {
    return {{{{-3.9921875, -4, 4}, 0, 0}, {{3992, 4000, 4000}, 20000, 64}, {{3992, -4000, 4000}, 20000, 0}}};
}

/// A floor 48 below the eye, a texel a unit.
Corners floor_48() {
    return {{{{-19200, -48, 12800}, -19200, 12800}, {{19200, -48, 12800}, 19200, 12800}, {{0, -48, 40}, 0, 40}}};
}

TEST(HardCaseX1, DepthsOf1To1000InOneRow) {
    const double exact = span_error("exact", receding_wall(), 110, 4, 319);
    std::printf("largest error in texels: exact %.6f, bounded %.1f, every16 %.1f, affine %.1f\n", exact,
                span_error("bounded", receding_wall(), 110, 4, 319),
                span_error("every16", receding_wall(), 110, 4, 319),
                span_error("affine", receding_wall(), 110, 4, 319));
    EXPECT_LE(exact, 1.0 / 16);
    EXPECT_GT(span_error("affine", receding_wall(), 110, 4, 319), 1000) << "the case is too tame";
}

TEST(HardCaseX2, AFloorAtTheHorizon) {
    EXPECT_LE(span_error("exact", floor_48(), 100, 1, 319), 1.0 / 16);  // z = 12,800
    EXPECT_LE(span_error("exact", floor_48(), 101, 100, 220), 1.0 / 16);
}

/// The gradients, anchored at a pixel, of corners whose texels are not negative.
TextureGradients gradients_of(const Corners& corners, PixelPosition anchor) {
    std::array<oblong::TexturedCorner, 3> exact;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto raw = [](double value) {
            return Fixed<std::int32_t, 14>::from_raw(static_cast<std::int32_t>(std::lround(value * 16384)));
        };
        const auto texel = [](double value) { return Texel::from_raw(std::llround(value * 65536)); };
        exact[i] = {{raw(corners[i].position.x), raw(corners[i].position.y), raw(corners[i].position.z)},
                    texel(corners[i].u),
                    texel(corners[i].v)};
    }
    return make_triangle_gradients(exact, make_projection({}, Degrees::from_int(90)), anchor).value();
}

TEST(HardCaseX2, NoRowAboveTheHorizonIsDrawn) {
    // The far edge, z = 12,800, lies at y = 100.5: the centres of row 100. The horizon itself at y = 100.
    FrameOutline frame;
    std::vector<reference::Vec> corners;
    for (const TexturedCorner& corner : floor_48()) corners.push_back(corner.position);
    ASSERT_TRUE(frame.make(corners));
    ScanlineExtents rows(200);
    scan_convex(frame.polygon.vertices, rows);
    EXPECT_EQ(rows.first, 100);
    EXPECT_EQ(rows.end, 200);
    Corners without_negatives = floor_48();
    for (TexturedCorner& corner : without_negatives) corner.u += 19200;
    for (std::int32_t row = rows.first; row < rows.end; ++row)
        for (std::int32_t column = rows.left[static_cast<std::size_t>(row)];
             column < rows.right[static_cast<std::size_t>(row)]; column += 7) {
            const auto inverse_z = gradients_of(without_negatives, {column, row}).inverse_z;
            // z = 48 * (400 / 3) / (row + 1/2 - 100), and 2^44 / z.
            ASSERT_NEAR(static_cast<double>(inverse_z.at(column, row).raw), 0x1p44 * (row - 99.5) / 6400, 2) << row;
        }
}

std::vector<TexelBlock> blocks_of(const TextureGradients& gradients, const Span& span, Texturing texturing,
                                  const TexelLimits& limits) {
    Accuracy accuracy;
    accuracy.texturing = texturing;
    const BlockRule rule = make_block_rule(accuracy);
    const auto thresholds = make_block_thresholds(rule, gradients.inverse_z.per_column);
    BlockList blocks(span.end - span.first);
    block_cutter(accuracy)({&span, 1}, 320, {gradients, limits, thresholds, rule.texel_bound_256}, blocks);
    return {blocks.waiting().begin(), blocks.waiting().end()};
}

/// A 64x48 bitmap one texel a pixel: a wall faced squarely at z = 160, its top left corner at pixel (col, row).
Corners one_to_one(int column, int row, double u0, double v0) {
    const auto corner = [&](double x, double y) {
        return TexturedCorner{{column + x - 160, (100 - row - y) * 1.2, 160}, u0 + x, v0 + y};
    };
    return {{corner(0, 0), corner(320, 0), corner(0, 320)}};
}

TEST(HardCaseX3, NoSampleOutsideTheSurfaceUpToTheLastPixel) {
    std::mt19937 random(3);
    for (int i = 0; i < 300; ++i) {
        const int width = random_integer(random, 1, 64), height = random_integer(random, 1, 48);
        const int column = random_integer(random, 0, 300), length = random_integer(random, 1, 320 - column);
        const TextureGradients gradients = gradients_of(receding_wall(), {column, 110});
        for (const Texturing texturing : kModes) {
            const TexelLimits limits = make_texel_limits(width, height, 512);
            for (const TexelBlock& block : blocks_of(gradients, {110, column, column + length}, texturing, limits))
                for (const std::int64_t at : {0, block.count - 1}) {
                    const std::int64_t u = block.u_16 + at * block.u_step_16, v = block.v_16 + at * block.v_step_16;
                    ASSERT_TRUE(u >= 0 && u < std::int64_t{width} << 16) << i;
                    ASSERT_TRUE(v >= 0 && v < std::int64_t{height} << 16) << i;
                }
        }
    }
}

/// A wall between two columns, of random depths up to the world's end: beyond its far end may lie its vanishing line.
Corners random_wall(std::mt19937& random) {
    const double left = random_between(random, 0, 150), right = random_between(random, 170, 320);
    const double near = std::exp(random_between(random, 1.4, 5)), far = std::exp(random_between(random, 1.4, 10.3));
    const auto corner = [](double column, double slope, double z, double u) {
        return TexturedCorner{{snapped((column - 160) / 160 * z), snapped(slope * z), snapped(z)}, u, 32 + 32 * slope};
    };
    return {{corner(left, -0.75, near, 0), corner(right, 0.75, far, 20000), corner(right, -0.75, far, 20000)}};
}

/// The pixels of row 110 whose centres lie between a wall's ends.
Span span_of_wall(const Corners& wall) {
    const double ends[] = {1 / wall[0].position.z, 1 / wall[1].position.z};
    Span span{110, 320, 0};
    for (int column = 0; column < 320; ++column) {
        const double inverse_z = texel_at(wall, kProjection, {column + 0.5, 110.5}).inverse_z;
        if (inverse_z < std::min(ends[0], ends[1]) || inverse_z > std::max(ends[0], ends[1])) continue;
        span.first = std::min(span.first, column);
        span.end = column + 1;
    }
    return span;
}

TEST(HardCaseX3, NoSampleBeyondTheTexelsOfTheSpansOwnEnds) {
    std::mt19937 random(33);
    const TexelLimits no_limits = make_texel_limits(65535, 65535, 0);
    for (int i = 0; i < 1000; ++i) {
        const Corners wall = random_wall(random);
        const Span span = span_of_wall(wall);
        if (span.end - span.first < 2) continue;
        const double u_first = texel_at(wall, kProjection, {span.first + 0.5, 110.5}).u,
                     u_last = texel_at(wall, kProjection, {span.end - 0.5, 110.5}).u;
        const TextureGradients gradients = gradients_of(wall, {(span.first + span.end) / 2, 110});
        // Half of the room is what the exact mode may be off by; a step that is rounded down drifts by 320 * 2^-16.
        const double room = 1.0 / 16;
        for (const Texturing texturing : kModes)
            for (const TexelBlock& block : blocks_of(gradients, span, texturing, no_limits))
                for (const std::int64_t at : {0, block.count - 1}) {
                    const double u = static_cast<double>(block.u_16 + at * block.u_step_16) / 65536;
                    ASSERT_GE(u, std::min(u_first, u_last) - room) << i << " mode " << static_cast<int>(texturing);
                    ASSERT_LE(u, std::max(u_first, u_last) + room) << i << " mode " << static_cast<int>(texturing);
                }
    }
}

TEST(HardCaseX4, ATexelAPixelReproducesTheBitmap) {
    for (const double shift : {0.0, 64.0, 128.0, 20000.0}) {
        for (const int row : {20, 21, 67}) {
            const auto found = ask_numbers("texspan " + texspan_fields(one_to_one(10, 20, shift, shift), row, 10, 74));
            for (std::size_t i = 0; i < 64; ++i) {
                ASSERT_EQ(std::floor(found.at(2 * i)), shift + static_cast<double>(i)) << row;
                ASSERT_EQ(std::floor(found.at(2 * i + 1)), shift + row - 20) << row;
            }
        }
    }
}

TEST(HardCaseX5, TilesFarFromTheOriginAreBitForBitThoseAtIt) {
    std::mt19937 random(5);
    for (int i = 0; i < 50; ++i) {
        Corners corners = receding_wall();
        for (TexturedCorner& corner : corners) corner.u = random_integer(random, 0, 2000 * 256) / 256.0;
        Corners shifted = corners;
        for (TexturedCorner& corner : shifted) corner.u += 20480;
        const auto here = ask_numbers("texspan " + texspan_fields(corners, 110, 10, 300));
        const auto there = ask_numbers("texspan " + texspan_fields(shifted, 110, 10, 300));
        ASSERT_EQ(here.size(), there.size());
        for (std::size_t k = 0; k < here.size(); k += 2) ASSERT_EQ(here[k] + 20480, there[k]) << k;
    }
}

TEST(HardCaseX6, NegativeTexelsWrapDownward) {
    const auto found = ask_numbers("texspan " + texspan_fields(one_to_one(10, 20, -37, -5), 22, 10, 74));
    for (std::size_t i = 0; i < 64; ++i) {
        const auto texel = static_cast<std::int64_t>(std::floor(found.at(2 * i)));
        ASSERT_EQ(texel, static_cast<std::int64_t>(i) - 37);
        ASSERT_EQ(texel & 63, (static_cast<std::int64_t>(i) + 64 - 37) % 64);
    }
}

TEST(HardCaseX7, SixtyFourBitAccumulatorsOverAWholeRow) {
    // Anchored at the row's far end, so that every step's rounding counts.
    const Corners corners = receding_wall();
    const TextureGradients gradients = gradients_of(corners, {319, 110});
    const TexelLimits limits = make_texel_limits(65535, 65535, 0);
    double worst = 0;
    for (int column = 0; column < 320; ++column) {
        const auto expected = texel_at(corners, kProjection, {column + 0.5, 110.5});
        const TexelPosition found = texel_at(gradients, limits, column, 110);
        worst = std::max(worst, std::abs(found.u_16 / 65536.0 - expected.u));
    }
    std::printf("largest error: %.6f texels\n", worst);
    EXPECT_LE(worst, 0.01);
}

TEST(HardCaseX9, SpansOf1AndOfABlockAndOneMore) {
    const TextureGradients gradients = gradients_of(one_to_one(10, 20, 0, 0), {10, 22});
    const TexelLimits limits = make_texel_limits(320, 320, 512);
    for (const int length : {1, 2, 15, 16, 17, 31, 32, 33, 255, 256, 257})
        for (const Texturing texturing : kModes) {
            std::int32_t column = 10;
            for (const TexelBlock& block : blocks_of(gradients, {22, 10, 10 + length}, texturing, limits))
                for (std::int64_t i = 0; i < block.count; ++i, ++column) {
                    const TexelPosition exact = texel_at(gradients, limits, column, 22);
                    ASSERT_EQ((block.u_16 + i * block.u_step_16) >> 16, exact.u_16 >> 16) << length << ' ' << column;
                }
            ASSERT_EQ(column, 10 + length);
        }
}

TEST(HardCaseX10, InverseDepthIsPositiveWhereverATriangleIsSeen) {
    std::mt19937 random(10);
    for (int i = 0; i < 3000; ++i) {
        Corners corners;
        double farthest = 0;
        for (TexturedCorner& corner : corners) {
            const double z = snapped(std::exp(random_between(random, 1.4, 10.3)));
            corner.position = {snapped(random_between(random, -z, z)),
                               snapped(random_between(random, -z * 0.75, z * 0.75)), z};
            farthest = std::max(farthest, z);
        }
        // The weights of a place inside, by its corners on the screen.
        const double a = random_between(random, 0, 1), b = random_between(random, 0, 1 - a);
        reference::ScreenPoint at;
        const double weights[] = {a, b, 1 - a - b};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto corner = reference::project(corners[k].position, kProjection);
            at = {at.x + weights[k] * corner.x, at.y + weights[k] * corner.y};
        }
        const auto column = static_cast<std::int32_t>(at.x), row = static_cast<std::int32_t>(at.y);
        const auto expected = texel_at(corners, kProjection, {column + 0.5, row + 0.5});
        if (!(expected.inverse_z >= 1 / farthest && expected.inverse_z <= 1 / 4.0)) continue;  // the centre is outside
        const auto quantity = gradients_of(corners, {column, row}).inverse_z;
        const double found = static_cast<double>(quantity.at(column, row).raw) / 0x1p44;
        // The projection's multipliers place pixels within 2^-32 of themselves: on a steep plane that shows.
        const auto beside = texel_at(corners, kProjection, {column + 1.5, row + 1.5});
        const double slope = std::abs(beside.inverse_z - expected.inverse_z);
        ASSERT_GT(found, 0);
        ASSERT_NEAR(found, expected.inverse_z, 0x1p-44 + (expected.inverse_z + slope) * 1e-9) << i;
    }
}

}  // namespace
}  // namespace oblong::test

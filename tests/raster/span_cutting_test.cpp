// The fast ways of cutting spans into blocks, held against the slow ones: divisions by the table, and cutters without
// clamps, that repeat rows, or for processors with BMI2.

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "engine/raster/texture_blocks.h"
#include "tests/support/random.h"

namespace oblong::test {

namespace {

constexpr std::int32_t kWidth = 320, kHeight = 200;

template <class Value>
double value_at(const LinearQuantity<Value>& quantity, std::int32_t column, std::int32_t row) {
    return number_of(quantity.origin) + number_of(quantity.per_column) * column + number_of(quantity.per_row) * row;
}

/// A plane at a random slope, and texels from far outside its surface to far inside.
TextureGradients random_plane(std::mt19937& random) {
    const auto part = [&](double least, double greatest) { return random_between(random, least, greatest); };
    const double w = std::exp2(part(-14, 1)), texels = std::exp2(part(0, 17));
    const auto slope = [&](double of) { return of * part(-1, 1) * std::exp2(part(-8, 2)) / kWidth; };
    TextureGradients plane;
    plane.inverse_z = {fixed_of<InverseZ>(w), fixed_of<InverseZ>(slope(w)), fixed_of<InverseZ>(slope(w))};
    const double u = w * texels * part(-1, 1), v = w * texels * part(-1, 1);
    plane.u_over_z = {fixed_of<TexelOverZ>(u), fixed_of<TexelOverZ>(slope(w * texels)), fixed_of<TexelOverZ>(slope(u))};
    plane.v_over_z = {fixed_of<TexelOverZ>(v), fixed_of<TexelOverZ>(slope(v)), fixed_of<TexelOverZ>(slope(w * texels))};
    return plane;
}

std::vector<Span> random_spans(std::mt19937& random) {
    const auto below = [&](std::int32_t end) { return random_below(random, end); };
    std::vector<Span> spans;
    for (std::int32_t row = below(100); row < kHeight; row += 1 + below(30)) {
        const std::int32_t first = below(kWidth);
        const bool is_repeated = !spans.empty() && below(3) > 0;
        spans.push_back(is_repeated ? Span{row, spans.back().first, spans.back().end}
                                    : Span{row, first, first + 1 + below(kWidth - first)});
    }
    return spans;
}

auto fields_of(const TexelBlock& block) {
    return std::tuple(block.pixel, block.count, block.u_16, block.v_16, block.u_step_16, block.v_step_16);
}

std::vector<decltype(fields_of({}))> cut(const std::vector<Span>& spans, const BlockCutting& cutting,
                                         BlockCutter cutter) {
    BlockList blocks(kWidth);
    std::vector<decltype(fields_of({}))> all;
    for (std::span<const Span> left = spans; !left.empty(); blocks.clear()) {
        left = cutter(left, kWidth, cutting, blocks);
        for (const TexelBlock& block : blocks.waiting()) all.push_back(fields_of(block));
    }
    return all;
}

}  // namespace

TEST(SpanCutting, StepsByTheTableAreThoseOfTheDivision) {
    std::mt19937 random(3);
    for (std::int32_t steps = 1; steps <= 600; ++steps)
        for (int trial = 0; trial < 400; ++trial) {
            // Around multiples of the divisor, where floors change, of every size.
            const std::int64_t most = (std::int64_t{1} << (8 + random() % 25)) - 1;
            const std::int64_t any = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * most)) - most;
            const std::int64_t whole = std::clamp(any / steps * steps + trial % 5 - 2, -most, most);
            const TexelPosition low{static_cast<std::uint32_t>(std::max<std::int64_t>(-whole, 0)), 0};
            const TexelPosition high{static_cast<std::uint32_t>(std::max<std::int64_t>(whole, 0)), 0};
            const double exact = std::floor(static_cast<double>(whole) / steps);
            if (std::abs(exact) < 0x1p31) {
                ASSERT_EQ(steps_by_division(low, high, steps).u_16, exact) << whole << " / " << steps;
                ASSERT_EQ(steps_by_division({0, low.u_16}, {0, high.u_16}, steps).v_16, exact);
            }
        }
}

TEST(SpanCutting, RangeFitsOnlyWhereEveryPixelIsInRange) {
    std::mt19937 random(5);
    int fitting = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const TextureGradients plane = random_plane(random);
        const std::vector<Span> spans = random_spans(random);
        const ScreenRectangle around = rectangle_around(spans);
        if (!fits_range(plane, around)) continue;
        ++fitting;
        for (std::int32_t row : {around.first_row, around.end_row - 1})
            for (std::int32_t column : {around.first_column, around.end_column - 1}) {
                const double w = value_at(plane.inverse_z, column, row);
                ASSERT_GE(w, 0x1p-20);
                ASSERT_LT(w, 0x1p15);
                ASSERT_LT(std::abs(value_at(plane.u_over_z, column, row)), w * 114688 * (1 + 1e-9));
                ASSERT_LT(std::abs(value_at(plane.v_over_z, column, row)), w * 114688 * (1 + 1e-9));
            }
    }
    EXPECT_GT(fitting, 1000);
    EXPECT_LT(fitting, 2900);
}

TEST(SpanCutting, EveryCutterCutsTheSameBlocks) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 1500; ++trial) {
        TextureGradients plane = random_plane(random);
        if (trial % 3 == 0) plane.inverse_z.per_row = {}, plane.u_over_z.per_row = {};  // a wall in a level view
        const std::vector<Span> spans = random_spans(random);
        for (const Texturing texturing : {Texturing::Bounded, Texturing::Every16, Texturing::BoundedTexels}) {
            Accuracy accuracy;
            accuracy.texturing = texturing;
            const BlockRule rule = make_block_rule(accuracy);
            BlockCutting cutting{plane, make_texel_limits(2048, 300, kWidth),
                                 make_block_thresholds(rule, plane.inverse_z.per_column), rule.texel_bound_256};
            const auto expected = cut(spans, cutting, block_cutter(accuracy, false));
            ASSERT_EQ(cut(spans, cutting, block_cutter(accuracy)), expected) << trial;
            cutting.fits_range = fits_range(plane, rectangle_around(spans));
            ASSERT_EQ(cut(spans, cutting, block_cutter(accuracy, false)), expected) << trial;
            ASSERT_EQ(cut(spans, cutting, block_cutter(accuracy)), expected) << trial;
        }
    }
}

TEST(SpanCutting, StopsWhereTheListIsFullAndGoesOnFromThere) {
    const std::vector<Span> rows(3000, Span{0, 0, 4});
    TextureGradients plane;
    plane.inverse_z = {fixed_of<InverseZ>(0.01), fixed_of<InverseZ>(1e-5), {}};
    Accuracy accuracy;
    accuracy.texturing = Texturing::Exact;
    const BlockCutting cutting{plane, make_texel_limits(64, 64, 0), {}};
    EXPECT_EQ(cut(rows, cutting, block_cutter(accuracy)).size(), 12000u);
}

}  // namespace oblong::test

// The fast ways of cutting spans into blocks, held against the slow ones: divisions by the table, and cutters without
// clamps, that repeat rows, take whole spans, or are for processors with BMI2.

#include <gtest/gtest.h>

#include <tuple>

#include "engine/raster/texture_blocks.h"
#include "tests/support/random.h"

namespace oblong::test::span_cutting_test {

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

/// Every kernel's cutter cuts these blocks.
void expect_cut(const std::vector<decltype(fields_of({}))>& expected, const std::vector<Span>& spans,
                const BlockCutting& cutting, const Accuracy& accuracy = {}) {
    for (const Kernels& kernels : all_kernels())
        ASSERT_EQ(cut(spans, cutting, block_cutter(accuracy, kernels)), expected) << kernels.name;
}

/// By the slow way.
auto cut_plainly(const std::vector<Span>& spans, const BlockCutting& cutting, const Accuracy& accuracy = {}) {
    return cut(spans, cutting, block_cutter(accuracy, all_kernels().back()));
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
        const std::int32_t width = trial % 4 == 0 ? 2048 : 200;
        for (const Texturing texturing : {Texturing::Bounded, Texturing::Every16, Texturing::BoundedTexels}) {
            Accuracy accuracy;
            accuracy.texturing = texturing;
            const BlockRule rule = make_block_rule(accuracy);
            BlockCutting cutting{plane, make_texel_limits(width, 300, kWidth),
                                 make_block_thresholds(rule, plane.inverse_z.per_column), rule.texel_bound_256};
            const auto expected = cut_plainly(spans, cutting, accuracy);
            ASSERT_NO_FATAL_FAILURE(expect_cut(expected, spans, cutting, accuracy)) << trial;
            cutting.fits_range = fits_range(plane, rectangle_around(spans));
            ASSERT_NO_FATAL_FAILURE(expect_cut(expected, spans, cutting, accuracy)) << trial;
        }
    }
}

// Spans that the thresholds would leave whole, cut by those and without them.
TEST(SpanCutting, WholeSpansAreTheBlocksThatThresholdsLeave) {
    std::mt19937 random(9);
    const BlockRule rule = make_block_rule({});
    int with_many_rows = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        TextureGradients plane = random_plane(random);
        plane.inverse_z.per_column = floor_shift(plane.inverse_z.per_column, 4 + trial % 12);
        if (trial % 3 == 0) plane.inverse_z.per_row = {}, plane.u_over_z.per_row = {};
        if (trial % 5 == 0) plane.inverse_z.per_column = {};
        const std::vector<Span> spans = random_spans(random);
        const ScreenRectangle around = rectangle_around(spans);
        if (!fits_range(plane, around)) continue;
        BlockCutting cutting{plane, make_texel_limits(1 + trial % 3000, 64, kWidth),
                             make_block_thresholds(rule, plane.inverse_z.per_column)};
        const auto expected = cut_plainly(spans, cutting);
        if (expected.size() != spans.size()) continue;
        with_many_rows += spans.size() > 8;
        cutting.fits_range = cutting.takes_whole_spans = true;
        ASSERT_NO_FATAL_FAILURE(expect_cut(expected, spans, cutting)) << trial;
    }
    EXPECT_GT(with_many_rows, 50);
}

// From the last texel of a surface to its first, where steps by a reciprocal are not exact on the larger ones.
TEST(SpanCutting, StepsAcrossWholeSurfacesAreTheSame) {
    std::vector<Span> spans;
    for (std::int32_t row = 0; row < 30; ++row) spans.push_back({row, 0, 2 + row});
    for (std::int32_t width = 500; width < 3000; ++width) {
        BlockCutting floor{{}, make_texel_limits(width, 64, kWidth), {}};
        floor.gradients.inverse_z = {fixed_of<InverseZ>(0x1p-7), {}, {}};
        floor.gradients.u_over_z = {fixed_of<TexelOverZ>(width * 0x1p-7), fixed_of<TexelOverZ>(width * -0x1p-7), {}};
        floor.fits_range = floor.takes_whole_spans = true;
        ASSERT_NO_FATAL_FAILURE(expect_cut(cut_plainly(spans, floor), spans, floor)) << width;
    }
}

// Blocks of one pixel each: so many in a row that none below repeats it, and fewer.
TEST(SpanCutting, RowsOfAnyNumberOfBlocksAreTheSameBelowOneAnother) {
    BlockCutting wall{{}, make_texel_limits(64, 64, kWidth), {}};
    wall.gradients.inverse_z = {fixed_of<InverseZ>(0.01), fixed_of<InverseZ>(1e-5), {}};
    wall.gradients.v_over_z = {fixed_of<TexelOverZ>(0.1), fixed_of<TexelOverZ>(1e-3), fixed_of<TexelOverZ>(1e-2)};
    std::fill(wall.thresholds.least_inverse_z.begin() + 1, wall.thresholds.least_inverse_z.end(), InverseZ::highest());
    for (std::int32_t width = 1; width <= 200; ++width) {
        const std::vector<Span> spans = {{0, 0, width}, {1, 0, width}, {2, 0, width}, {5, 0, width}};
        wall.fits_range = false;
        const auto expected = cut_plainly(spans, wall);
        ASSERT_EQ(expected.size(), as_size(4 * width));
        wall.fits_range = true;
        ASSERT_NO_FATAL_FAILURE(expect_cut(expected, spans, wall)) << width;
    }
}

TEST(SpanCutting, EndsInTheColumnOfAnEndBeforeAreNoDivisions) {
    BlockCutting wall{{}, make_texel_limits(64, 64, kWidth), {}};
    wall.gradients.inverse_z = {fixed_of<InverseZ>(0.01), fixed_of<InverseZ>(1e-8), {}};
    wall.fits_range = wall.takes_whole_spans = true;
    const std::vector<Span> spans = {{0, 0, 50}, {1, 0, 50}, {2, 5, 50}, {3, 5, 6}, {4, 6, 9}};
    for (const Kernels& kernels : all_kernels()) {
        BlockList blocks(kWidth);
        block_cutter({}, kernels)(spans, kWidth, wall, blocks);
        EXPECT_EQ(divisions_of(spans, wall, blocks), 5);  // at 0 and 49, 5, 6 and 8
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

TEST(SpanCutting, RowsInTheSameColumnsStopWhereTheListIsFull) {
    const std::vector<Span> rows(3000, Span{0, 0, 64});
    TextureGradients wall;
    wall.inverse_z = {fixed_of<InverseZ>(0.01), fixed_of<InverseZ>(1e-4), {}};
    const Accuracy accuracy;  // bounded
    BlockCutting cutting{wall, make_texel_limits(64, 64, kWidth),
                         make_block_thresholds(make_block_rule(accuracy), wall.inverse_z.per_column)};
    const std::size_t expected = cut(rows, cutting, block_cutter(accuracy)).size();
    cutting.fits_range = true;
    for (const Kernels& kernels : all_kernels()) {
        BlockList blocks(kWidth);
        std::size_t count = 0;
        for (std::span<const Span> left = rows; !left.empty(); blocks.clear()) {
            left = block_cutter(accuracy, kernels)(left, kWidth, cutting, blocks);
            count += blocks.waiting().size();
            ASSERT_LT(blocks.end(), blocks.last_start() + kWidth);
        }
        EXPECT_EQ(count, expected);
    }
}

}  // namespace oblong::test::span_cutting_test

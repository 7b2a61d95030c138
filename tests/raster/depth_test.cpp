// The depth buffer against 2^32 / z in doubles.
#include "engine/raster/depth.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/random.h"

namespace oblong::test::depth_test {

namespace {

constexpr std::int32_t kWidth = 320, kHeight = 200;

/// Rows of 1/z that rises to the right and down.
struct Slope {
    double origin = 0.004, per_column = 0.00001, per_row = 0.00002;

    LinearQuantity<InverseZ> quantity() const {
        return {fixed_of<InverseZ>(origin), fixed_of<InverseZ>(per_column), fixed_of<InverseZ>(per_row)};
    }
    double steps(std::int32_t column, std::int32_t row) const {
        return std::ldexp(origin + per_column * column + per_row * row, 32);
    }
};

std::vector<Span> rows(std::int32_t count) {
    std::vector<Span> spans;
    for (std::int32_t y = 0; y < count; ++y) spans.push_back({y, 0, kWidth});
    return spans;
}

/// Cleared at the start of a frame in which it is wanted there.
DepthBuffer depth_wanted(const std::vector<ScreenRectangle>& wanted) {
    DepthBuffer depth(kWidth, kHeight);
    depth.start_frame();
    for (const ScreenRectangle& rectangle : wanted) depth.want(rectangle);
    depth.clear();
    return depth;
}

bool holds(const ScreenRectangle& outer, const ScreenRectangle& inner) {
    return outer.first_column <= inner.first_column && outer.end_column >= inner.end_column &&
           outer.first_row <= inner.first_row && outer.end_row >= inner.end_row;
}

}  // namespace

TEST(DepthBuffer, HoldsTheInverseDepthOfAPlaneWhereItIsWanted) {
    const std::vector<ScreenRectangle> wanted{{10, 40, 20, 60}, {200, 320, 150, 200}, {35, 70, 50, 90}};
    DepthBuffer depth = depth_wanted(wanted);
    const Slope slope;
    depth.fill(rows(kHeight), slope.quantity());
    for (const ScreenRectangle& rectangle : wanted)
        for (std::int32_t y = rectangle.first_row; y < rectangle.end_row; ++y)
            for (std::int32_t x = rectangle.first_column; x < rectangle.end_column; ++x)
                // In the middle of the two steps above an even number; steps of 2^-44 are half a step off, 520 times.
                ASSERT_NEAR(depth.row(y)[x] + 1.0, slope.steps(x, y), 1.1) << x << ", " << y;
}

TEST(DepthBuffer, IsInfinitelyFarWhereNoFaceWasFilled) {
    DepthBuffer depth(kWidth, kHeight);
    for (int frame = 0; frame < 2; ++frame) {
        depth.start_frame();
        depth.want({0, 50, 0, 50});
        depth.clear();
        if (frame == 0) depth.fill(rows(kHeight), Slope{}.quantity());
    }
    EXPECT_EQ(std::count(depth.row(20), depth.row(20) + 50, 0u), 50);
}

TEST(DepthBuffer, ClampsWhatIsNearerThanAUnitOrBehindTheEye) {
    DepthBuffer depth = depth_wanted({{0, kWidth, 0, 1}});
    depth.fill(rows(1), Slope{-1, 0.01, 0}.quantity());
    EXPECT_EQ(depth.row(0)[50], 0u) << "1/z = -0.5";
    EXPECT_NEAR(depth.row(0)[150], std::ldexp(0.5, 32), 2);
    EXPECT_EQ(depth.row(0)[250], 0xfffffffeu) << "1/z = 1.5";
    depth.fill(rows(1), Slope{1, 0, 0}.quantity());
    EXPECT_EQ(depth.row(0)[50], 0xfffffffeu) << "1/z = 1";
}

TEST(DepthBuffer, ThingsAloneHideWhatIsSeenThrough) {
    DepthBuffer depth = depth_wanted({{100, 110, 0, 1}});
    depth.fill(rows(1), Slope{0.01, 0, 0}.quantity());
    const auto inverse = [](std::int64_t z) { return InverseZ::from_raw((1LL << InverseZ::kFractionBits) / z); };
    for (int x = 102; x < 106; ++x) depth.row(0)[x] = to_inverse_depth(inverse(50)) | kThingBit;
    const auto seen = [&](std::int64_t z) {
        std::vector<Span> spans;
        depth.append_seen(std::vector<Span>{{0, 90, 120}}, {inverse(z), {}, {}}, spans);
        std::string columns;
        for (const Span& span : spans) columns += std::to_string(span.first) + "-" + std::to_string(span.end) + " ";
        return columns;
    };
    EXPECT_EQ(seen(200), "90-102 106-120 ") << "behind the face, too";
    EXPECT_EQ(seen(60), "90-102 106-120 ");
    EXPECT_EQ(seen(50), "90-120 ") << "as near";
    EXPECT_EQ(seen(40), "90-120 ");
}

TEST(DepthBuffer, IsNotWantedWithoutARectangle) {
    DepthBuffer depth(kWidth, kHeight);
    depth.start_frame();
    depth.want({30, 30, 0, 200});
    EXPECT_FALSE(depth.is_wanted());
    depth.want({30, 31, 0, 200});
    EXPECT_TRUE(depth.is_wanted());
    depth.start_frame();
    EXPECT_FALSE(depth.is_wanted());
}

TEST(DepthBuffer, CoversWhatIsWantedByFewRectangles) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 50; ++trial) {
        DepthBuffer depth(kWidth, kHeight);
        std::vector<ScreenRectangle> wanted;
        for (int i = 0; i < 200; ++i) {
            const std::int32_t x = random_below(random, 310), y = random_below(random, 190);
            wanted.push_back({x, x + 1 + random_below(random, 10), y, y + 1 + random_below(random, 10)});
            depth.want(wanted.back());
        }
        EXPECT_LE(depth.rectangles().size(), 16u);
        for (const ScreenRectangle& rectangle : wanted)
            ASSERT_TRUE(std::any_of(depth.rectangles().begin(), depth.rectangles().end(),
                                    [&](const ScreenRectangle& outer) { return holds(outer, rectangle); }));
    }
}

TEST(DepthBuffer, FewSmallRectanglesStayApart) {
    DepthBuffer depth(kWidth, kHeight);
    depth.want({0, 4, 0, 4});
    depth.want({300, 304, 190, 194});
    depth.want({2, 6, 2, 6});
    std::int64_t area = 0;
    for (const ScreenRectangle& each : depth.rectangles())
        area += std::int64_t{each.end_column - each.first_column} * (each.end_row - each.first_row);
    EXPECT_LE(area, 16 + 36);
}

TEST(DepthBuffer, SpansTouchItOnlyWhereTheyReachIntoItsRows) {
    const DepthBuffer depth = depth_wanted({{100, 110, 50, 60}});
    const auto touches = [&depth](Span span) {
        const std::vector<Span> spans{{0, 0, 320}, span};
        return depth.touches(spans, rectangle_around(spans));
    };
    for (const Span& span : {Span{50, 0, 101}, {59, 109, 320}}) EXPECT_TRUE(touches(span)) << span.y;
    for (const Span& span : {Span{50, 0, 100}, {59, 110, 320}, {49, 0, 320}, {60, 0, 320}})
        EXPECT_FALSE(touches(span)) << span.y << ", " << span.first;
}

}  // namespace oblong::test::depth_test

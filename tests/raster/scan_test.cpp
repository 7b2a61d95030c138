#include "engine/raster/scan.h"

#include <gtest/gtest.h>

#include <utility>

#include "engine/raster/edges.h"
#include "tests/support/random.h"

namespace oblong::test::scan_test {

namespace {

constexpr std::int32_t kSize_8 = kLargestMode_px * 256;

/// ceil(numerator / denominator); denominator above 0.
std::int64_t ceiling(std::int64_t numerator, std::int64_t denominator) {
    return numerator / denominator + (numerator % denominator > 0);
}

/// The first column whose centre lies at or right of an edge in the middle of a row, by one exact fraction.
std::int64_t column_by_fraction(ScreenVertex top, ScreenVertex bottom, std::int32_t row) {
    const std::int64_t dx = bottom.x.raw - top.x.raw, dy = bottom.y.raw - top.y.raw;
    return ceiling((top.x.raw - std::int64_t{128}) * dy + (row * std::int64_t{256} + 128 - top.y.raw) * dx, dy * 256);
}

/// The number that, times `value`, leaves 1 modulo `modulus`; 0 if there is none.
std::int64_t inverse(std::int64_t value, std::int64_t modulus) {
    std::int64_t old_rest = value, rest = modulus, old_factor = 1, factor = 0;
    while (rest != 0) {
        const std::int64_t quotient = old_rest / rest;
        old_rest = std::exchange(rest, old_rest - quotient * rest);
        old_factor = std::exchange(factor, old_factor - quotient * factor);
    }
    return old_rest == 1 ? (old_factor + modulus) % modulus : 0;
}

ScreenVertex at_8(std::int32_t x_8, std::int32_t y_8) {
    return {Screen::from_raw(x_8), Screen::from_raw(y_8)};
}

/// A coordinate on a screen of `size_8`: anywhere, on a pixel's centre or border, a step beside, or at the screen's
/// end.
std::int32_t hard_coordinate(std::mt19937& random, std::int32_t size_8) {
    const auto any = random_below(random, size_8 + 1);
    const std::int32_t chosen[]{any, any & ~127, (any & ~127) + 1, (any & ~127) - 1, size_8, 0};
    return std::clamp(chosen[random() % 6], 0, size_8);
}

/// Holds each row of a walk, from its first row and from its middle on, against the fraction.
template <class Walker>
void expect_exact(ScreenVertex top, ScreenVertex bottom) {
    const std::int32_t first = first_centre_from(top.y), end = first_centre_from(bottom.y);
    if (first >= end) return;
    Walker walker(top, bottom, first), late(top, bottom, (first + end) / 2);
    for (std::int32_t row = first; row < end; ++row, walker.next_row()) {
        ASSERT_EQ(walker.column(), column_by_fraction(top, bottom, row)) << row;
        if (row < (first + end) / 2) continue;
        ASSERT_EQ(late.column(), walker.column()) << row;
        late.next_row();
    }
}

std::vector<ScreenVertex> moved(std::vector<ScreenVertex> polygon, std::int32_t columns, std::int32_t rows) {
    for (ScreenVertex& v : polygon) v = {v.x + Screen::from_int(columns), v.y + Screen::from_int(rows)};
    return polygon;
}

/// Points around an ellipse, clockwise as seen; `bend_8` moves each by up to as much.
std::vector<ScreenVertex> random_polygon(std::mt19937& random, std::int32_t width, std::int32_t height,
                                         std::int32_t bend_8) {
    const auto up_to = [&](std::int32_t most) { return random_below(random, most + 1); };
    std::vector<double> turns(3 + random() % 8);
    for (double& turn : turns) turn = up_to(1 << 20) * 6.283185307179586 / (1 << 20);
    std::sort(turns.begin(), turns.end());
    const std::int32_t x = up_to(width * 256), y = up_to(height * 256), across = up_to(width * 128),
                       down = up_to(height * 128);
    std::vector<ScreenVertex> polygon;
    for (const double turn : turns) {
        const double at_x = x + across * std::cos(turn), at_y = y + down * std::sin(turn);
        polygon.push_back(at_8(std::clamp(static_cast<std::int32_t>(at_x) + up_to(bend_8), 0, width * 256),
                               std::clamp(static_cast<std::int32_t>(at_y) + up_to(bend_8), 0, height * 256)));
    }
    return polygon;
}

/// How often a closed chain turns from down to up or back.
int vertical_turns(const std::vector<ScreenVertex>& polygon) {
    std::vector<bool> goes_down;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Screen from = polygon[i].y, to = polygon[(i + 1) % polygon.size()].y;
        if (from != to) goes_down.push_back(from < to);
    }
    int turns = 0;
    for (std::size_t i = 0; i < goes_down.size(); ++i) turns += goes_down[i] != goes_down[(i + 1) % goes_down.size()];
    return turns;
}

void expect_same_rows(const ScanlineExtents& expected, const ScanlineExtents& found, PixelRange rows,
                      std::int32_t columns_moved) {
    ASSERT_EQ(found.first, rows.first);
    ASSERT_EQ(found.end, rows.end);
    for (auto row = static_cast<std::size_t>(rows.first); row < static_cast<std::size_t>(rows.end); ++row) {
        ASSERT_EQ(found.left[row], expected.left[row] + columns_moved) << row;
        ASSERT_EQ(found.right[row], expected.right[row] + columns_moved) << row;
    }
}

}  // namespace

TEST(EdgeWalkers, GiveTheColumnsOfTheExactEdgeOnTheLargestScreen) {
    std::mt19937 random(1);
    for (int i = 0; i < 3000; ++i) {
        const auto y = std::minmax({hard_coordinate(random, kSize_8), hard_coordinate(random, kSize_8)});
        const ScreenVertex top = at_8(hard_coordinate(random, kSize_8), y.first),
                           bottom = at_8(hard_coordinate(random, kSize_8), y.second);
        ASSERT_NO_FATAL_FAILURE(expect_exact<ScreenWalker>(top, bottom)) << i;
        ASSERT_NO_FATAL_FAILURE(expect_exact<ExactWalker>(top, bottom)) << i;
    }
}

TEST(EdgeWalkers, TellOnWhichSideAnEdgePassesACentreByTheLeastThereIs) {
    // In its last row each edge is 1 / (256 dy) pixel right of a column's centre: dx is the inverse of the way down to
    // that row, modulo dy, and the edge begins where the rest makes whole pixels.
    int edges = 0;
    for (std::int32_t dy = kSize_8; dy > kSize_8 - 3000; --dy) {
        const std::int32_t last_row = first_centre_from(Screen::from_raw(dy)) - 1, down = last_row * 256 + 128;
        const std::int64_t dx = inverse(down, dy);
        if (dx == 0 || dx > kSize_8 - 256) continue;
        const std::int64_t x = (128 - (down * dx - 1) / dy) & 255;
        for (const bool is_beside : {false, true}) {
            const ScreenVertex top = at_8(static_cast<std::int32_t>(x) - is_beside, 0),
                               bottom = at_8(top.x.raw + static_cast<std::int32_t>(dx), dy);
            if (top.x < Screen{}) continue;
            ScreenWalker walker(top, bottom, 0), late(top, bottom, last_row);
            for (std::int32_t row = 0; row < last_row; ++row) walker.next_row();
            ASSERT_EQ(walker.column(), column_by_fraction(top, bottom, last_row));
            ASSERT_EQ(late.column(), walker.column());
        }
        ++edges;
    }
    EXPECT_GT(edges, 1000);
}

TEST(EdgeWalkers, GiveTheColumnsOfFlatEdges) {
    for (std::int32_t dy_8 = 1; dy_8 < 512; ++dy_8)
        for (const std::int32_t top_8 : {127, 128, 0, 129 - std::min(dy_8, 129), kSize_8 - dy_8})
            for (const std::int32_t x_8 : {0, 1, 128, kSize_8 - 1, kSize_8}) {
                const std::int32_t other_8 = kSize_8 - x_8;
                ASSERT_NO_FATAL_FAILURE(expect_exact<ScreenWalker>(at_8(x_8, top_8), at_8(other_8, top_8 + dy_8)));
            }
}

TEST(Scan, IsTheSameOnTheScreenAndBesideIt) {
    // Polygons that reach off the screen are walked with remainders.
    std::mt19937 random(3);
    constexpr std::int32_t kWidth = 320, kHeight = 200, kAway = -5000;
    int bent = 0, covered = 0;
    for (int i = 0; i < 5000; ++i) {
        const auto polygon = random_polygon(random, kWidth, kHeight, i % 2 ? 700 : 0);
        ScanlineExtents on(kHeight), beside(kHeight);
        scan_convex(moved(polygon, kAway, 0), beside);
        scan_convex(polygon, on);
        ASSERT_NO_FATAL_FAILURE(expect_same_rows(on, beside, {on.first, on.end}, kAway)) << i;
        bent += !is_monotone(polygon);
        covered += on.first < on.end;
    }
    EXPECT_GT(bent, 50);
    EXPECT_GT(covered, 2500);
}

TEST(Scan, FindsNoMoreThanTheShapeTells) {
    std::mt19937 random(4);
    for (int i = 0; i < 4000; ++i) {
        const auto polygon = random_polygon(random, 320, 200, 2);
        for (const EdgeStepping stepping : {EdgeStepping::Exact, EdgeStepping::Accumulated}) {
            const PolygonShape shape = shape_of(polygon, 200, stepping);
            ASSERT_EQ(is_monotone(polygon), vertical_turns(polygon) <= 2) << i;
            ScanlineExtents rows(200);
            scan_convex(polygon, rows, stepping);
            ASSERT_EQ(rows.first, shape.bounds.first_row);
            ASSERT_EQ(rows.end, shape.bounds.end_row);
            for (auto row = static_cast<std::size_t>(rows.first); row < static_cast<std::size_t>(rows.end); ++row) {
                if (rows.left[row] >= rows.right[row]) continue;
                ASSERT_GE(rows.left[row], shape.bounds.first_column) << i;
                ASSERT_LE(rows.right[row], shape.bounds.end_column) << i;
            }
        }
    }
}

TEST(Scan, OfSomeRowsHasTheSameColumns) {
    std::mt19937 random(5);
    for (int i = 0; i < 4000; ++i) {
        const auto polygon = random_polygon(random, 320, 200, 2);
        for (const EdgeStepping stepping : {EdgeStepping::Exact, EdgeStepping::Accumulated}) {
            ScanlineExtents all(200), some(200);
            scan_convex(polygon, all, stepping);
            if (all.first >= all.end) continue;
            const std::int32_t rows = all.end - all.first;
            const auto any = [&] { return all.first + random_below(random, rows); };
            const auto [first, last] = std::minmax({any(), any()});
            scan_convex(polygon, shape_of(polygon, 200, stepping), {first, last + 1}, some);
            ASSERT_NO_FATAL_FAILURE(expect_same_rows(all, some, {first, last + 1}, 0)) << i;
        }
    }
}

TEST(Scan, OfTooFewCornersIsEmpty) {
    ScanlineExtents rows(200);
    for (const std::vector<ScreenVertex>& corners :
         {std::vector<ScreenVertex>{}, {at_8(0, 0)}, {at_8(0, 0), at_8(9000, 9000)}}) {
        scan_convex(corners, rows);
        EXPECT_EQ(rows.first, rows.end);
    }
}

}  // namespace oblong::test::scan_test

#include <gtest/gtest.h>

#include <cmath>

#include "engine/visibility/box_culler.h"
#include "tests/visibility/visibility_fixture.h"

namespace oblong::test::box_rectangle_test {

namespace {

/// Of a world that reaches `reach` units either way.
ViewContext random_view(std::mt19937& random, std::int32_t reach = 2000) {
    const auto coordinate = [&] { return random_below(random, 2 * reach) - reach; };
    const Vec3<World> eye{World::from_int(coordinate()), World::from_int(coordinate()), World::from_int(coordinate())};
    return view_along(eye, random_axes(random), {}, 20 + random_below(random, 130));
}

/// Column and row, in doubles, of a point of the box.
std::pair<double, double> seen_at(const ViewContext& view, const Point& p) {
    const Point way = p - to_point(view.eye);
    const double depth = dot(way, to_point(view.axes.forward));
    return {160 + number_of(view.projection.x.multiplier) * dot(way, to_point(view.axes.right)) / depth,
            100 - number_of(view.projection.y.multiplier) * dot(way, to_point(view.axes.up)) / depth};
}

struct Tally {
    int on_screen = 0, small = 0;
};

/// Points of random boxes, in doubles, are in the boxes' rectangles.
Tally check_boxes(std::int32_t reach, std::int32_t largest) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> part(0, 1);
    Tally tally;
    for (int trial = 0; trial < 20000; ++trial) {
        const ViewContext view = random_view(random, reach);
        const LevelBox box = random_box(random, reach, largest);
        const std::optional<ScreenRectangle> rectangle = rectangle_of(box, view);
        if (!rectangle) continue;
        tally.small +=
            (rectangle->end_column - rectangle->first_column) * (rectangle->end_row - rectangle->first_row) < 6400;
        for (int point = 0; point < 8; ++point) {
            const auto at = [&](std::size_t axis) {
                const double along = trial % 2 ? std::round(part(random)) : part(random);
                return box.mins[axis] + along * (box.maxs[axis] - box.mins[axis]);
            };
            const auto [column, row] = seen_at(view, {at(0), at(1), at(2)});
            if (column < 0 || column >= 320 || row < 0 || row >= 200) continue;
            ++tally.on_screen;
            EXPECT_GE(column, rectangle->first_column);
            EXPECT_LE(column, rectangle->end_column);
            EXPECT_GE(row, rectangle->first_row);
            EXPECT_LE(row, rectangle->end_row);
        }
    }
    return tally;
}

}  // namespace

TEST(BoxRectangle, HoldsAllOfTheBoxThatIsOnTheScreen) {
    const Tally tally = check_boxes(2000, 300);
    EXPECT_GT(tally.on_screen, 1000);
    EXPECT_GT(tally.small, 1000) << "a rectangle that is always large hides nothing";
}

TEST(BoxRectangle, HoldsBoxesAsLargeAsTheWorld) {
    EXPECT_GT(check_boxes(524'287, 80'000).on_screen, 1000);
    EXPECT_GT(check_boxes(524'287, 2 * 524'287).on_screen, 1000);
}

/// As wide as BSP2 files may have it, before the eye and past it.
TEST(BoxRectangle, OfTheWholeWorldIsAnywhere) {
    constexpr std::int32_t kFar = 524'287;
    std::mt19937 random(11);
    for (int trial = 0; trial < 1000; ++trial)
        EXPECT_FALSE(rectangle_of({{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}}, random_view(random, kFar)));
}

}  // namespace oblong::test::box_rectangle_test

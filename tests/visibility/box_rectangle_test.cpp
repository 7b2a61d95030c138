#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/visibility/box_culler.h"

namespace oblong::test {

namespace {

/// Of a world that reaches `reach` units either way.
ViewContext random_view(std::mt19937& random, std::int32_t reach = 2000) {
    ViewContext view;
    const auto coordinate = [&] {
        return World::from_int(static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(2 * reach)) - reach);
    };
    view.eye = {coordinate(), coordinate(), coordinate()};
    view.axes = view_basis(Angle::from_bam(random()), Angle::from_bam(random()), Angle::from_bam(random()));
    view.viewpoint = {view.eye};
    view.rays = view.axes;
    view.projection = make_projection(ScreenMode{}, Degrees::from_int(20 + random() % 130));
    view.frustum = make_frustum(view.axes, view.projection);
    view.grid = SubpixelGrid::of_bits(8);
    return view;
}

LevelBox random_box(std::mt19937& random, std::int32_t reach, std::int32_t largest) {
    LevelBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.mins[axis] = static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(2 * reach)) - reach;
        box.maxs[axis] = box.mins[axis] + static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(largest));
        box.maxs[axis] = std::min(box.maxs[axis], reach);
    }
    return box;
}

double to_double(Unit component) {
    return std::ldexp(component.raw, -30);
}

/// Column and row, in doubles, of a point of the box.
std::pair<double, double> seen_at(const ViewContext& view, double x, double y, double z) {
    const double dx = x - std::ldexp(view.eye.x.raw, -12), dy = y - std::ldexp(view.eye.y.raw, -12);
    const double dz = z - std::ldexp(view.eye.z.raw, -12);
    const auto along = [&](const Vec3<Unit>& axis) {
        return dx * to_double(axis.x) + dy * to_double(axis.y) + dz * to_double(axis.z);
    };
    const double depth = along(view.axes.forward);
    const auto multiplier = [](const ProjectionAxis& axis) {
        return std::ldexp(static_cast<double>(axis.multiplier.raw), -32);
    };
    return {160 + multiplier(view.projection.x) * along(view.axes.right) / depth,
            100 - multiplier(view.projection.y) * along(view.axes.up) / depth};
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
            const double x = at(0), y = at(1), z = at(2);
            const auto [column, row] = seen_at(view, x, y, z);
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

TEST(BoxRectangle, AroundTheEyeIsAnywhere) {
    std::mt19937 random(10);
    const ViewContext view = random_view(random);
    const auto unit = [](World w) { return floor_shift(w.raw, 12); };
    const LevelBox box{{unit(view.eye.x) - 8, unit(view.eye.y) - 8, unit(view.eye.z) - 8},
                       {unit(view.eye.x) + 8, unit(view.eye.y) + 8, unit(view.eye.z) + 8}};
    EXPECT_FALSE(rectangle_of(box, view));
}

}  // namespace oblong::test

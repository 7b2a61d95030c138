// Lines clipped to six planes, against the part of the line that is inside by exact fractions.

#include <gtest/gtest.h>

#include "engine/methods/lines.h"
#include "tests/properties/any_view.h"

namespace oblong::test::clip_line_test {
namespace {

using Point = Vec3<View>;
constexpr View kFront = View::from_raw(4'096), kBack = View::from_int(1'000);

struct AnyView {
    Projection projection = any_projection(10, 170);
    ViewVolume volume = make_view_volume(frustum_of(projection), kFront, kBack);
};

/// Within `units` of the eye along each axis; often on an axis, or exactly on the front or back plane.
Point any_point(std::int64_t units) {
    const auto along = [units] {
        return View::from_raw(*rc::gen::oneOf(rc::gen::inRange<std::int64_t>(-units * 65'536, units * 65'536),
                                              rc::gen::element<std::int64_t>(0, kFront.raw, kBack.raw, 1, -1)));
    };
    return {along(), along(), along()};
}

ViewLine any_line() {
    const std::int64_t units = *rc::gen::element<std::int64_t>(2, 100, 3'000, 1'800'000);
    return {any_point(units), any_point(units)};
}

__extension__ using Wide = __int128;

/// A part of a line's length, exact.
struct Part {
    Wide part, whole;
    bool operator<(const Part& other) const { return part * other.whole < other.part * whole; }
    long double value() const { return static_cast<long double>(part) / static_cast<long double>(whole); }
};

/// Where the line is inside all planes: nothing where `enters` is past `leaves`.
struct Inside {
    Part enters{0, 1}, leaves{1, 1};
    bool is_empty = false;
};

Inside exact_inside(const ViewVolume& volume, const ViewLine& line) {
    Inside inside;
    for (const ClipPlane& plane : volume.planes) {
        const Wide d0 = plane.distance(line.from).raw, d1 = plane.distance(line.to).raw;
        if (d0 < 0 && d1 < 0) inside.is_empty = true;
        if (d0 < 0 && d1 >= 0) inside.enters = std::max(inside.enters, Part{-d0, d1 - d0});
        if (d1 < 0 && d0 >= 0) inside.leaves = std::min(inside.leaves, Part{d0, d0 - d1});
    }
    inside.is_empty |= inside.leaves < inside.enters;
    return inside;
}

/// A place in steps of 2^-16 unit.
using Steps = std::array<long double, 3>;

Steps steps_of(const Point& p) {
    return {static_cast<long double>(p.x.raw), static_cast<long double>(p.y.raw), static_cast<long double>(p.z.raw)};
}
Steps exact_place(const ViewLine& line, const Part& at) {
    const Steps from = steps_of(line.from), way = steps_of(line.to - line.from);
    return {from[0] + way[0] * at.value(), from[1] + way[1] * at.value(), from[2] + way[2] * at.value()};
}
long double largest_difference(const Steps& a, const Steps& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

RC_GTEST_PROP(LiangBarsky, EndsWhereTheLineEntersAndLeaves, ()) {
    const AnyView view = AnyView();
    const ViewLine line = any_line();
    const Inside inside = exact_inside(view.volume, line);
    const auto clipped = clip_line(view.volume, line, LineClipping::LiangBarsky);
    if (clipped.has_value() == inside.is_empty) {  // a point, kept or not
        // None of a line, or a point of it, may be rounded into the other.
        RC_ASSERT(largest_difference(exact_place(line, inside.enters), exact_place(line, inside.leaves)) < 1);
        return;
    }
    if (!clipped) return;
    RC_ASSERT(largest_difference(steps_of(clipped->from), exact_place(line, inside.enters)) <= 1);
    RC_ASSERT(largest_difference(steps_of(clipped->to), exact_place(line, inside.leaves)) <= 1);
}

RC_GTEST_PROP(LineClipping, LeavesLinesInTheVolumeAsTheyAre, ()) {
    const AnyView view = AnyView();
    const ViewLine line = any_line();
    const bool is_inside = outcode_of(view.volume, line.from) == 0 && outcode_of(view.volume, line.to) == 0;
    for (const LineClipping method : {LineClipping::CohenSutherland, LineClipping::LiangBarsky}) {
        const auto clipped = clip_line(view.volume, line, method);
        if (is_inside) RC_ASSERT(clipped && clipped->from == line.from && clipped->to == line.to);
        if ((outcode_of(view.volume, line.from) & outcode_of(view.volume, line.to)) != 0) RC_ASSERT(!clipped);
    }
}

/// The distance of a point from the whole straight line, in steps of 2^-16 unit.
long double steps_beside(const ViewLine& line, const Point& p) {
    const Steps along = steps_of(line.to - line.from), way = steps_of(p - line.from);
    const long double x = along[1] * way[2] - along[2] * way[1], y = along[2] * way[0] - along[0] * way[2],
                      z = along[0] * way[1] - along[1] * way[0];
    return std::sqrt(x * x + y * y + z * z) / std::hypot(along[0], along[1], along[2]);
}

/// Rounding an end at a plane moves the next crossing by more, the flatter the line meets that plane. So what is asked
/// is that ends are on the line, in the volume, and either the line's own or on a plane: give or take some steps.
RC_GTEST_PROP(CohenSutherland, LeavesTheWholePartInTheVolume, ()) {
    constexpr ClipDistance kSteps = ClipDistance::from_raw(8 << ClipNormal::kFractionBits);
    const AnyView view = AnyView();
    const ViewLine line{any_point(3'000), any_point(3'000)};
    const auto clipped = clip_line(view.volume, line, LineClipping::CohenSutherland);
    if (!clipped) {
        ViewVolume smaller = view.volume;
        for (ClipPlane& plane : smaller.planes) plane.offset += kSteps;
        RC_ASSERT(exact_inside(smaller, line).is_empty);
        return;
    }
    for (const Point& end : {clipped->from, clipped->to}) {
        bool is_at_end = end == line.from || end == line.to;
        for (const ClipPlane& plane : view.volume.planes) {
            const ClipDistance distance = plane.distance(end);
            RC_ASSERT(distance > -kSteps);
            is_at_end |= distance < kSteps;
        }
        RC_ASSERT(is_at_end);
        RC_ASSERT(line.from == line.to || steps_beside(line, end) < 8);
    }
}

TEST(Outcodes, HaveABitForEachPlane) {
    const Projection projection = make_projection({200, 200, {1, 1}}, Degrees::from_int(90));
    const ViewVolume volume = make_view_volume(frustum_of(projection), View::from_int(1), View::from_int(10));
    struct Row {
        int x, y, z;
        unsigned outcode;
    };
    for (const auto& [x, y, z, outcode] : {Row{0, 0, 5, 0},
                                           {-5, 5, 5, 0},  // on two planes
                                           {-6, 0, 5, kOutLeft},
                                           {6, 0, 5, kOutRight},
                                           {0, -6, 5, kOutBottom},
                                           {0, 6, 5, kOutTop},
                                           {0, 0, 0, kOutFront},
                                           {0, 0, 11, kOutBack},
                                           {0, 0, -1, kOutFront | kOutLeft | kOutRight | kOutBottom | kOutTop}})
        EXPECT_EQ(outcode_of(volume, {View::from_int(x), View::from_int(y), View::from_int(z)}), outcode)
            << x << " " << y << " " << z;
}

// From behind the eye to in front of it: the part in view is right of the middle, where the line is, and not left of
// it, where dividing by the negative z would put the other end.
TEST(ProjectLine, OfOneEndBehindTheEyeIsOnTheRightSide) {
    const Projection projection = make_projection({320, 200, {8, 5}}, Degrees::from_int(90));
    const ViewVolume volume = make_view_volume(frustum_of(projection), View::from_raw(64), View::from_int(1'000));
    const auto at = [](std::int64_t x, std::int64_t z) { return Point{View::from_int(x), {}, View::from_int(z)}; };
    const auto line = project_line(volume, projection, {at(4, -4), at(4, 16)});
    ASSERT_TRUE(line);
    EXPECT_EQ(line->from, (PixelPosition{319, 100}));  // x = z at (4, 4)
    EXPECT_EQ(line->to, (PixelPosition{200, 100}));    // 160 + 160 * 4 / 16
    EXPECT_FALSE(project_line(volume, projection, {at(4, -4), at(40, -1)}));
}

RC_GTEST_PROP(ProjectLine, StaysOnTheScreen, ()) {
    const AnyView view = AnyView();
    const auto line = project_line(view.volume, view.projection, any_line());
    if (!line) return;
    for (const PixelPosition& end : {line->from, line->to}) {
        RC_ASSERT(end.column >= 0 && end.column < view.projection.width_px);
        RC_ASSERT(end.row >= 0 && end.row < view.projection.height_px);
    }
}

}  // namespace
}  // namespace oblong::test::clip_line_test

#include "tools/map/source/brush.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/level/level.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

using map::Box;

// Whether a box overlaps a convex brush, by separating axes: their planes and the cross products of their edges.
bool overlaps(const map::Brush& brush, const Box& mover, const Point& at) {
    std::vector<Point> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, corners;
    for (const auto& side : brush.sides) {
        axes.push_back(map::area_vector(side.winding));
        for (std::size_t i = 0; i < side.winding.size(); ++i) {
            corners.push_back(side.winding[i]);
            const Point edge = side.winding[(i + 1) % side.winding.size()] - side.winding[i];
            for (int axis = 0; axis < 3; ++axis) axes.push_back(cross(edge, map::axis_vector(axis)));
        }
    }
    for (const Point& axis : axes) {
        if (length(axis) < 1e-6) continue;
        double brush_low = 1e30, brush_high = -1e30, box_low = 1e30, box_high = -1e30;
        for (const Point& corner : corners) {
            brush_low = std::min(brush_low, dot(axis, corner));
            brush_high = std::max(brush_high, dot(axis, corner));
        }
        for (int i = 0; i < 8; ++i) {
            const Point corner = at + Point{i & 1 ? mover.maxs.x : mover.mins.x, i & 2 ? mover.maxs.y : mover.mins.y,
                                            i & 4 ? mover.maxs.z : mover.mins.z};
            box_low = std::min(box_low, dot(axis, corner));
            box_high = std::max(box_high, dot(axis, corner));
        }
        if (box_high <= brush_low || brush_high <= box_low) return false;
    }
    return true;
}

// Points of whole numbers on the plane a x + b y + c z = d, up to 2^29 away: its normal is (a, b, c) divided by its
// length. At a level's corners the plane is where it should be within half of what is taken as on it.
TEST(Brushes, PlanesOfFarPointsAreExact) {
    std::mt19937 random(11);
    const auto whole = [&](int most) {
        return static_cast<double>(static_cast<int>(random_between(random, -most, most)));
    };
    for (int i = 0; i < 20000; ++i) {
        const int far = 1 << (i % 25);
        const Point normal{whole(17), whole(17), whole(17)}, near{whole(1000), whole(1000), whole(1000)};
        const Point u{normal.y, -normal.x, 0}, v{normal.z, 0, -normal.x};
        map::MapSide side;
        for (Point& point : side.points) point = near + u * whole(far) + v * whole(far);
        const Point across = cross(side.points[0] - side.points[1], side.points[2] - side.points[1]);
        if (normal.x == 0 || length(across) < 1e-6) continue;
        const double size = length(normal) * (dot(across, normal) > 0 ? 1 : -1);
        const map::Plane plane = map::plane_of(side);
        const double off = length(plane.normal - normal * (1 / size)) * 4096 * std::sqrt(3.0);
        ASSERT_LT(off + std::abs(plane.distance - dot(normal, near) / size), map::kOnEpsilon / 2) << far;
    }
}

// A player stands in a clip hull exactly where the player's box overlaps a brush: also at edges and corners.
TEST(Brushes, GrownByAMoverAreSolidWhereTheMoversBoxOverlapsABrush) {
    const std::string shape = ball({0, 0, 256}, 90, 4, 6);
    const std::string source = level(room({-512, -512, 0}, {512, 512, 512}) + shape);
    const auto bsp = compile(source);
    map::PlaneList planes;
    map::TextureList textures;
    const map::Brush brush = map::make_brush(map::parse_map(level(shape)).front().brushes.front(), planes, textures);
    std::mt19937 random(5);
    int solid = 0;
    for (int i = 0; i < 4000; ++i) {
        const Point at{random_between(random, -160, 160), random_between(random, -160, 160),
                       random_between(random, 96, 416)};
        for (const int hull : {1, 2}) {
            const Box mover = hull == 1 ? Box{{-16, -16, -24}, {16, 16, 32}} : Box{{-32, -32, -24}, {32, 32, 64}};
            const bool is_solid = contents_at(bsp, 0, hull, at) == contents::kSolid;
            const bool is_surely_in = overlaps(brush, mover.grown(-0.05), at);
            const bool is_surely_out = !overlaps(brush, mover.grown(0.05), at);
            EXPECT_FALSE(is_surely_in && !is_solid) << hull << ": " << at.x << ' ' << at.y << ' ' << at.z;
            EXPECT_FALSE(is_surely_out && is_solid) << hull << ": " << at.x << ' ' << at.y << ' ' << at.z;
            solid += is_solid;
        }
    }
    EXPECT_GT(solid, 1000);
}

TEST(Brushes, LargeMoversArePlayersInADraft) {
    const auto bsp = compile(
        level(room({0, 0, 0}, {256, 256, 256}), entity("func_wall", {}, box({64, 64, 0}, {96, 96, 64}))), {true});
    for (const map::FileModel& model : bsp.models) EXPECT_EQ(model.head_nodes[2], model.head_nodes[1]);
    EXPECT_EQ(contents_at(bsp, 0, 2, {16.5, 128, 24.5}), contents::kEmpty);
    EXPECT_EQ(contents_at(bsp, 0, 2, {15.5, 128, 24.5}), contents::kSolid);
}

TEST(Brushes, WithoutExtentAreRefused) {
    expect_complaint("{\n\"classname\" \"worldspawn\"\n{\n( 0 0 0 ) ( 1 1 1 ) ( 2 2 2 ) wall 0 0 0 1 1\n}\n}\n",
                     "line 4: the three points of a plane lie on one line");
    expect_complaint(level(brush({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}})), "enclose no volume");
    expect_complaint(level(box({0, 0, 0}, {0, 16, 16})), "the three points of a plane lie on one line");
    expect_complaint(level(box({16, 0, 0}, {0, 16, 16})), "line 3: the sides of this brush enclose no volume");
}

TEST(Brushes, OutOfTheFormatsReachAreNamedByTheirLine) {
    expect_complaint(level(plain_room() + box({40000, 0, 0}, {40016, 16, 16})), "this brush reaches farther from the");
    EXPECT_EQ(complaint_of(level(room({-32751, 0, 0}, {-32600, 64, 64}), entity_at("light", {-32700, 32, 32}))),
              "none");
}

TEST(Brushes, SidesSaidTwiceOrOutOfReachChangeNothing) {
    const std::string cube = box({96, 96, 0}, {128, 128, 64});
    const std::string first_side = cube.substr(2, cube.find('\n', 2) - 1);
    const std::string beyond = "( 900 0 0 ) ( 900 0 16 ) ( 900 16 0 ) wall 0 0 0 1 1\n";
    const auto with = [&](const std::string& sides) {
        return bytes_of(level(plain_room() + "{\n" + sides + cube.substr(2), lights_of_plain_room()));
    };
    EXPECT_EQ(with(first_side), with(""));
    EXPECT_EQ(compile(level(plain_room() + "{\n" + beyond + cube.substr(2), lights_of_plain_room())).faces.size(),
              compile(level(plain_room() + cube, lights_of_plain_room())).faces.size());
}

}  // namespace
}  // namespace oblong::test

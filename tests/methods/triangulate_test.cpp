#include "engine/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "engine/methods/polygons.h"
#include "tests/support/point.h"

namespace oblong::test::triangulate_test {
namespace {

using Polygon = std::vector<Vec3<World>>;

/// Twice the signed area as seen from +z, in square steps of 2^-24 units, exact for what is tested here.
std::int64_t doubled_area(const Polygon& corners, std::span<const std::uint32_t> order) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Vec3<World>&a = corners[order[i]], &b = corners[order[(i + 1) % order.size()]];
        sum += std::int64_t{a.x.raw} * b.y.raw - std::int64_t{b.x.raw} * a.y.raw;
    }
    return sum;
}

std::int64_t doubled_area(const Polygon& corners) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < corners.size(); ++i) order.push_back(i);
    return doubled_area(corners, order);
}

/// Triangles that all turn as the polygon does, and whose areas add up to its own, neither overlap nor leave a gap.
void expect_tiling(const Polygon& corners, const Polygon& with_middle, const std::vector<CornerTriple>& triangles) {
    std::int64_t sum = 0;
    const std::int64_t whole = doubled_area(corners);
    for (const CornerTriple& triangle : triangles) {
        const std::int64_t area = doubled_area(with_middle, triangle);
        ASSERT_GE(whole > 0 ? area : -area, 0) << "turned over";
        sum += area;
    }
    ASSERT_EQ(sum, whole);
}

/// A point by its direction and distance from the middle.
Vec3<World> around(double angle, double steps) {
    const auto world = [](double raw) { return World::from_raw(static_cast<std::int32_t>(std::lround(raw))); };
    return {world(steps * std::cos(angle)), world(steps * std::sin(angle)), World{}};
}

/// Corners on a circle: convex.
Polygon any_convex(std::mt19937& random) {
    std::uniform_real_distribution<double> any_angle(0, 6.283185);
    std::uniform_int_distribution<std::size_t> any_count(3, 11);
    std::set<double> angles;
    for (const std::size_t count = any_count(random); angles.size() < count;) angles.insert(any_angle(random));
    Polygon polygon;
    for (const double angle : angles) polygon.push_back(around(angle, 4e5));
    return polygon;
}

/// Corners in the order of their angles about the middle, at any distance: concave, and crosses itself nowhere.
Polygon any_star(std::mt19937& random) {
    std::uniform_real_distribution<double> any_distance(1e4, 4e5);
    const int count = std::uniform_int_distribution<int>(4, 23)(random);
    Polygon polygon;
    for (int i = 0; i < count; ++i) polygon.push_back(around(6.283185307 * i / count, any_distance(random)));
    return polygon;
}

TEST(Triangulation, AllThreeTileAConvexPolygon) {
    std::mt19937 random(1);
    for (int i = 0; i < 500; ++i) {
        const Polygon polygon = any_convex(random);
        const std::size_t n = polygon.size();
        ASSERT_EQ(triangulate_as_fan(n).size(), n - 2);
        ASSERT_NO_FATAL_FAILURE(expect_tiling(polygon, polygon, triangulate_as_fan(n)));
        ASSERT_EQ(triangulate_by_diagonals(polygon).size(), n - 2);
        ASSERT_NO_FATAL_FAILURE(expect_tiling(polygon, polygon, triangulate_by_diagonals(polygon)));
        Polygon with_middle = polygon;
        with_middle.push_back(middle_of(polygon));
        ASSERT_EQ(triangulate_around_middle(n).size(), n);
        // On a narrow polygon the rounded middle may lie a step outside of an edge.
        if (n < 5) continue;
        ASSERT_NO_FATAL_FAILURE(expect_tiling(polygon, with_middle, triangulate_around_middle(n)));
    }
}

TEST(Triangulation, DiagonalsTileConcavePolygonsOfEitherOrientation) {
    std::mt19937 random(2);
    for (int i = 0; i < 500; ++i) {
        Polygon polygon = any_star(random);
        ASSERT_NO_FATAL_FAILURE(expect_tiling(polygon, polygon, triangulate_by_diagonals(polygon)));
        std::reverse(polygon.begin(), polygon.end());
        ASSERT_NO_FATAL_FAILURE(expect_tiling(polygon, polygon, triangulate_by_diagonals(polygon)));
        ASSERT_EQ(triangulate_by_diagonals(polygon).size(), polygon.size() - 2);
    }
}

TEST(Triangulation, CornersOnALineAndRepeatedOnesStillGiveTwoFewerTriangles) {
    const Polygon on_edges{point_at(0, 0, 0), point_at(2, 0, 0), point_at(4, 0, 0), point_at(4, 4, 0),
                           point_at(4, 4, 0), point_at(2, 4, 0), point_at(0, 4, 0), point_at(0, 2, 0)};
    EXPECT_EQ(triangulate_by_diagonals(on_edges).size(), on_edges.size() - 2);
    expect_tiling(on_edges, on_edges, triangulate_by_diagonals(on_edges));
    const Polygon point(5, point_at(1, 1, 1)),
        bow{point_at(0, 0, 0), point_at(4, 4, 0), point_at(4, 0, 0), point_at(0, 4, 0)};
    EXPECT_EQ(triangulate_by_diagonals(point).size(), 3u);
    EXPECT_EQ(triangulate_by_diagonals(bow).size(), 2u) << "crosses itself";
    EXPECT_TRUE(triangulate_by_diagonals({}).empty());
    EXPECT_TRUE(triangulate_as_fan(2).empty());
}

TEST(Triangulation, SeesAPolygonFromWhereItIsLargestAndAtTheEndsOfTheFormat) {
    const World low = World::lowest(), high = World::highest();
    const Polygon wall{{low, World{}, low},
                       {high, World{}, low},
                       {World{}, World{}, World{}},
                       {high, World{}, high},
                       {low, World{}, high}};
    const auto triangles = triangulate_by_diagonals(wall);
    ASSERT_EQ(triangles.size(), 3u);
    for (const CornerTriple& triangle : triangles)  // a diagonal from corner 1 to 3 would lie outside
        EXPECT_FALSE(std::set<std::uint32_t>(triangle.begin(), triangle.end()) == (std::set<std::uint32_t>{1, 2, 3}));
    EXPECT_EQ(middle_of(Polygon{{low, low, low}, {low, low, low}}), (Vec3<World>{low, low, low}));
}

}  // namespace
}  // namespace oblong::test::triangulate_test

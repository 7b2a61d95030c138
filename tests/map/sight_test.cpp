#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "tests/support/random.h"
#include "tools/map/vis/visibility.h"

namespace oblong::test::sight_test {
namespace {

using map::Plane, map::Point, map::Winding;

// A convex polygon in a plane of some z, or turned about the x axis; some have edges parallel to the axes.
Winding polygon(std::mt19937& random, double z) {
    const bool is_box = random_below(random, 2) == 0;
    const int corners = is_box ? 4 : 3 + random_below(random, 4);
    const double first = is_box ? 0.25 : random_between(random, 0, 1), size = random_between(random, 8, 64);
    const double slope = is_box ? 0 : random_between(random, -0.5, 0.5);
    const double x = 8 * random_below(random, 12), y = 8 * random_below(random, 12);
    Winding winding;
    for (int i = 0; i < corners; ++i) {
        const double angle = -2 * std::numbers::pi * (i + first) / corners - std::numbers::pi / 4;
        const double across = size * std::cos(angle), up = size * std::sin(angle);
        winding.push_back({x + across, y + up, z + slope * up});
    }
    return winding;
}

double least_height(const Winding& winding, const Plane& plane) {
    double least = 1e9;
    for (const Point& point : winding) least = std::min(least, plane.height_of(point));
    return least;
}

// By definition: of all planes through an edge of one and a corner of the other, facing either way, those with the
// source behind and the pass in front.
std::vector<Plane> all_separators(const Winding& source, const Winding& pass) {
    std::vector<Plane> found;
    const auto add = [&](const Winding& edges, const Winding& corners) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (const Point& corner : corners) {
                const Point normal = cross(edges[(i + 1) % edges.size()] - edges[i], corner - edges[i]);
                for (const double sign : {1.0, -1.0}) {
                    const Point unit = normal * (sign / length(normal));
                    const Plane plane{unit, dot(unit, edges[i])};
                    if (least_height(pass, plane) > -1e-6 && least_height(source, plane.flipped()) > -1e-6)
                        found.push_back(plane);
                }
            }
        }
    };
    add(source, pass);
    add(pass, source);
    return found;
}

double least_height(const std::vector<Plane>& planes, const Point& point) {
    double least = 1e9;
    for (const Plane& plane : planes) least = std::min(least, plane.height_of(point));
    return least;
}

TEST(Separators, BoundTheSameSpaceAsAllThatThereAre) {
    std::mt19937 random(9);
    std::vector<Plane> planes;
    int inside = 0, outside = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const Winding source = polygon(random, 0), pass = polygon(random, 128);
        const std::vector<Plane> expected = all_separators(source, pass);
        find_separators(source, pass, planes);
        ASSERT_GE(planes.size(), 3u) << trial;
        for (int i = 0; i < 200; ++i) {
            const Point point{random_between(random, -300, 400), random_between(random, -300, 400),
                              random_between(random, 200, 500)};
            const double height = least_height(expected, point);
            EXPECT_NEAR(least_height(planes, point), height, 0.01) << trial;
            ++(height > 0 ? inside : outside);
        }
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(outside, 1000);
}

TEST(Separators, EachIsThereOnce) {
    const Winding source{{0, 0, 0}, {0, 64, 0}, {64, 64, 0}, {64, 0, 0}};
    const Winding pass{{16, 16, 128}, {16, 32, 128}, {48, 32, 128}, {48, 16, 128}};
    std::vector<Plane> planes;
    find_separators(source, pass, planes);
    EXPECT_EQ(planes.size(), 4u);  // each through an edge of both
}

}  // namespace
}  // namespace oblong::test::sight_test

#include "tools/reference/rays.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/reference_polygons.h"

namespace oblong::reference::rays_test {
namespace {

std::int64_t random_integer(std::mt19937& random, std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
}

bool is_inside(const std::optional<RayTriangle>& triangle, const RayGrid& grid, int column, int row) {
    if (!triangle) return false;
    const Interval inside = triangle->inside(grid, row);
    return column >= inside.first && column < inside.end;
}

TEST(Rays, InFrontOfTheEyeTrianglesCoverWhatExactEdgeFunctionsSay) {
    std::mt19937 random(1);
    const RayGrid grid{24, 16, {}};
    int covered = 0;
    for (int i = 0; i < 3000; ++i) {
        std::array<GridPoint, 3> points;
        std::array<RayCorner, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            // Often on pixel centres and their rows and columns, so that rays meet edges and corners.
            const std::int64_t step = i % 2 == 0 ? 128 : 1, depth = random_integer(random, 1, 1 << 20);
            points[k] = {random_integer(random, -4 * 256 / step, 28 * 256 / step) * step,
                         random_integer(random, -4 * 256 / step, 20 * 256 / step) * step};
            corners[k] = {(points[k].x - 12 * 256) * depth, (points[k].y - 8 * 256) * depth, 256 * depth};
        }
        const auto triangle = RayTriangle::make(corners[0], corners[1], corners[2]);
        for (int row = 0; row < grid.height_px; ++row)
            for (int column = 0; column < grid.width_px; ++column) {
                const bool expected = covers(points, column, row);
                covered += expected;
                ASSERT_EQ(is_inside(triangle, grid, column, row), expected) << i << ' ' << column << ' ' << row;
            }
    }
    EXPECT_GT(covered, 100000);
}

TEST(Rays, AClosedMeshAroundTheEyeCoversEveryRayOnce) {
    // A cube's corners, each anywhere in its octant: on small whole numbers many rays meet edges and corners.
    constexpr std::array<std::array<std::size_t, 4>, 6> kSides{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    std::mt19937 random(2);
    const RayGrid grid{8, 8, {}};
    for (int i = 0; i < 500; ++i) {
        std::array<RayCorner, 8> corners;
        for (std::size_t k = 0; k < 8; ++k) {
            const auto part = [&](unsigned bit) { return random_integer(random, 1, 7) * ((k & bit) != 0 ? 1 : -1); };
            corners[k] = {part(1), part(2), part(4)};
        }
        for (int row = 0; row < 8; ++row)
            for (int column = 0; column < 8; ++column) {
                int winding = 0;
                for (const auto& side : kSides) {
                    const std::array polygon{corners[side[0]], corners[side[1]], corners[side[2]], corners[side[3]]};
                    for (const RayTriangle& triangle : make_ray_fan(polygon))
                        winding += is_inside(triangle, grid, column, row) ? triangle.winding() : 0;
                }
                ASSERT_EQ(winding, 1) << i << ' ' << column << ' ' << row;
            }
    }
}

TEST(Rays, ATriangleInAPlaneThroughTheEyeCoversNothing) {
    EXPECT_FALSE(RayTriangle::make({1, 2, 3}, {4, 5, 6}, {5, 7, 9}));
}

TEST(Rays, OrientationIsExactForTheLargestCorners) {
    // Products of 165 bits that cancel: det(a, b, c) = det(a, b - a, c - a) = n det((1 1 1), (0 -1 0), (0 0 -1)) = n.
    constexpr std::int64_t n = (std::int64_t{1} << 55) - 1;
    const RayCorner a{n, n, n}, b{n, n - 1, n}, c{n, n, n - 1};
    ASSERT_TRUE(RayTriangle::make(a, b, c));
    EXPECT_EQ(RayTriangle::make(a, b, c)->winding(), 1);
    EXPECT_EQ(RayTriangle::make(b, a, c)->winding(), -1);
    EXPECT_FALSE(RayTriangle::make(a, b, {n, n - 2, n}));
}

TEST(Rays, CornersTooFarForExactDeterminantsAreRefused) {
    EXPECT_THROW(make_ray_corner({1e12, 0, 0}, make_camera({})), std::range_error);
}

}  // namespace
}  // namespace oblong::reference::rays_test

// The pixels of meshes: texels and depth against rays in doubles. Coverage is that of the scan (draw_mesh_test.cpp).
#include <gtest/gtest.h>

#include "engine/view/project.h"
#include "tests/mesh/mesh_picture.h"

namespace oblong::test {
namespace {

struct Hit {
    double u, v, distance;  ///< along the view
    bool is_inside, is_near_edge;
};

/// A ray through a place on the screen and a triangle, by Cramer's rule.
Hit hit(const std::array<Point, 3>& corners, const std::array<std::array<double, 2>, 3>& texels, double column,
        double row) {
    const Point ray{1, -(column - 160) / 160, -(row - 100) / (160 / 1.2)};
    const Point &a = corners[0], &b = corners[1], &c = corners[2];
    const double whole = dot(a, cross(b, c));
    const double wa = dot(ray, cross(b, c)) / whole, wb = dot(ray, cross(c, a)) / whole,
                 wc = dot(ray, cross(a, b)) / whole;
    const double sum = wa + wb + wc;
    const double least = std::min({wa, wb, wc}) / sum;
    return {(wa * texels[0][0] + wb * texels[1][0] + wc * texels[2][0]) / sum,
            (wa * texels[0][1] + wb * texels[1][1] + wc * texels[2][1]) / sum, 1 / sum, sum > 0 && least >= 0,
            std::abs(least) < 1e-3};
}

/// A skin whose texels are the numbers of their column, or of their row; wider than high.
Skin numbered_skin(bool by_column) {
    constexpr std::size_t kWidth = 255, kHeight = 250;
    Skin skin{"numbered", kWidth, kHeight, std::vector<std::uint8_t>(kWidth * kHeight)};
    for (std::size_t i = 0; i < skin.texels.size(); ++i)
        skin.texels[i] = static_cast<std::uint8_t>(by_column ? i % kWidth : i / kWidth);
    return skin;
}

TEST(MeshPixels, ShowTheTexelAndDepthOfTheirRay) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> ahead(40, 300), side(-120, 120), texel(1, 249);
    std::int64_t compared = 0;
    for (int i = 0; i < 60; ++i) {
        MeshBuilder builder;
        std::array<Point, 3> corners;
        std::array<std::array<double, 2>, 3> texels;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Vec3<World> p = world_point(ahead(random), side(random), side(random));
            texels[corner] = {texel(random), texel(random)};
            builder.add(p, texels[corner][0], texels[corner][1]);
            corners[corner] = to_point(p);
        }
        builder.triangle(0, 1, 2, 0);
        builder.triangle(0, 2, 1, 0);
        builder.mesh.skins = {numbered_skin(true), numbered_skin(false)};
        for (const bool by_column : {true, false}) {
            PlacedMesh placed = placed_at(builder.done());
            placed.skin = by_column ? 0 : 1;
            MeshPicture picture(view_from({}));
            picture.draw(placed, unshaded());
            for (std::int32_t y = 0; y < 200; ++y)
                for (std::int32_t x = 0; x < 320; ++x) {
                    const Hit middle = hit(corners, texels, x + 0.5, y + 0.5);
                    if (middle.is_near_edge) continue;
                    ASSERT_EQ(picture.at(x, y) != 255, middle.is_inside) << i << ": " << x << ", " << y;
                    if (!middle.is_inside) continue;
                    // Corners are rounded to 1/256 pixel: a texel may be that of a place so far away.
                    double least = 1e9, most = -1e9, nearest = 1e9, farthest = 0;
                    for (const double dx : {-0.004, 0.0, 0.004})
                        for (const double dy : {-0.004, 0.0, 0.004}) {
                            const Hit here = hit(corners, texels, x + 0.5 + dx, y + 0.5 + dy);
                            const double value = by_column ? here.u : here.v;
                            least = std::min(least, value), most = std::max(most, value);
                            nearest = std::min(nearest, here.distance), farthest = std::max(farthest, here.distance);
                        }
                    ASSERT_GE(picture.at(x, y), std::floor(least - 0.01)) << i << ": " << x << ", " << y;
                    ASSERT_LE(picture.at(x, y), std::floor(most + 0.01)) << i << ": " << x << ", " << y;
                    const double depth = std::ldexp(1.0, 32) / picture.depth.row(y)[x];
                    ASSERT_GE(depth, nearest * 0.99999);
                    ASSERT_LE(depth, farthest * 1.00001);
                    ++compared;
                }
        }
    }
    EXPECT_GT(compared, 100'000);
}

/// Within a triangle u and v go evenly over the screen.
TEST(MeshPixels, AffineTexelsGoEvenlyOverTheScreen) {
    MeshBuilder builder;
    // Projected to columns 80 and 240; twice as far on the right.
    builder.add(world_point(100, 50, 40), 0, 0);
    builder.add(world_point(200, -100, 80), 160, 0);
    builder.add(world_point(100, 50, -40), 0, 80);
    builder.triangle(0, 1, 2);
    builder.mesh.skins = {numbered_skin(true), numbered_skin(false)};
    MeshPicture affine(view_from({})), rows(view_from({})), perspective(view_from({}));
    PlacedMesh by_row = placed_at(builder.done());
    by_row.skin = 1;
    affine.draw(placed_at(builder.mesh), unshaded(), {}, true);
    rows.draw(by_row, unshaded(), {}, true);
    perspective.draw(placed_at(builder.mesh), unshaded());
    // 80 texels on 320 / 3 rows from 140 / 3 on.
    for (std::int32_t y = 47; y < 150; ++y) EXPECT_EQ(rows.at(80, y), std::floor((y + 0.5 - 140 / 3.0) * 0.75)) << y;
    for (std::int32_t x = 80; x < 160; ++x) EXPECT_EQ(affine.at(x, 60), x - 80) << x;
    // u = 160 s / (2 - s) of the way s over the screen.
    for (std::int32_t x = 82; x < 160; ++x) {
        const double s = (x + 0.5 - 80) / 160;
        EXPECT_NEAR(perspective.at(x, 60), std::floor(160 * s / (2 - s)), 1) << x;
    }
}

TEST(MeshPixels, NearerPixelsStay) {
    const Mesh ball = ball_mesh(20, 12, plain_skin(3)), other = ball_mesh(20, 12, plain_skin(4));
    const PlacedMesh near_one = placed_at(ball, world_point(100, 10, 0)),
                     far_one = placed_at(other, world_point(110, -10, 0));
    MeshPicture one(view_from({})), two(view_from({}));
    one.draw(near_one, unshaded());
    one.draw(far_one, unshaded());
    two.draw(far_one, unshaded());
    two.draw(near_one, unshaded());
    EXPECT_EQ(one.pixels, two.pixels);
    EXPECT_GT(std::count(one.pixels.begin(), one.pixels.end(), 3), 1000);
    EXPECT_GT(std::count(one.pixels.begin(), one.pixels.end(), 4), 500);
}

}  // namespace
}  // namespace oblong::test

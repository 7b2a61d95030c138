#include "engine/methods/canonical_volume.h"

#include <gtest/gtest.h>

#include "engine/methods/transforms.h"
#include "engine/view/project.h"
#include "tests/support/random.h"

namespace oblong::test::canonical_volume_test {
namespace {

using Real4 = std::array<double, 4>;

Vec4 corner(double x, double y, double z = 0.5, double w = 1) {
    return {fixed_of<Entry>(x), fixed_of<Entry>(y), fixed_of<Entry>(z), fixed_of<Entry>(w)};
}

/// The coordinates that the six sides of the volume compare, without the engine's function.
std::array<double, 6> distances(const Vec4& p) {
    const double x = number_of(p.x), y = number_of(p.y), z = number_of(p.z), w = number_of(p.w);
    return {w + x, w - x, w + y, w - y, z, w - z};
}

double doubled_area(const std::vector<Vec4>& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec4 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double ax = number_of(a.x) / number_of(a.w), ay = number_of(a.y) / number_of(a.w);
        sum += ax * number_of(b.y) / number_of(b.w) - number_of(b.x) / number_of(b.w) * ay;
    }
    return sum;
}

TEST(CanonicalVolume, OutcodeHasABitForEachSideAndThoseOnItAreInside) {
    EXPECT_EQ(volume_outcode(corner(-2, 0)), 1u);
    EXPECT_EQ(volume_outcode(corner(2, 0)), 2u);
    EXPECT_EQ(volume_outcode(corner(0, -2)), 4u);
    EXPECT_EQ(volume_outcode(corner(0, 2)), 8u);
    EXPECT_EQ(volume_outcode(corner(0, 0, -0.5)), 16u);
    EXPECT_EQ(volume_outcode(corner(0, 0, 2)), 32u);
    EXPECT_EQ(volume_outcode(corner(1, -1, 1)), 0u);
    EXPECT_EQ(volume_outcode(corner(-1, 1, 0)), 0u);
    EXPECT_EQ(volume_outcode({Entry::highest(), Entry::lowest(), Entry::lowest(), Entry::highest()}), 16u + 4u);
}

std::vector<Vec4> any_triangle(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> any(-size, size);
    std::vector<Vec4> triangle;
    for (int i = 0; i < 3; ++i) triangle.push_back(corner(any(random), any(random), any(random), any(random)));
    return triangle;
}

Real4 numbers_of(const Vec4& p) {
    return {number_of(p.x), number_of(p.y), number_of(p.z), number_of(p.w)};
}

/// Points of a triangle, by weights in twelfths.
std::vector<Real4> points_of(const std::vector<Vec4>& triangle) {
    std::vector<Real4> points;
    for (int a = 0; a <= 12; ++a)
        for (int b = 0; a + b <= 12; ++b) {
            const Real4 p = numbers_of(triangle[0]), q = numbers_of(triangle[1]), r = numbers_of(triangle[2]);
            Real4 sum{};
            for (std::size_t j = 0; j < 4; ++j) sum[j] = (a * p[j] + b * q[j] + (12 - a - b) * r[j]) / 12;
            points.push_back(sum);
        }
    return points;
}

double along(const Real4& form, const Real4& p) {
    return form[0] * p[0] + form[1] * p[1] + form[2] * p[2] + form[3] * p[3];
}

/// A point that is inside of all sides is a mean of the clipped polygon's corners, so that no linear form is larger
/// there than at all of them.
void expect_holds(const std::vector<Vec4>& clipped, const Real4& p) {
    for (const Real4& form : {Real4{1, 0, 0, 0}, Real4{0, 1, 0, 0}, Real4{0, 0, 1, 0}, Real4{0, 0, 0, 1},
                              Real4{-1, 0, 0, 0}, Real4{0, -1, 0, 0}, Real4{1, 2, -1, 3}, Real4{-2, 1, 3, -1}}) {
        double most = -1e9;
        for (const Vec4& corner : clipped) most = std::max(most, along(form, numbers_of(corner)));
        ASSERT_LE(along(form, p), most + 1e-7);
    }
}

TEST(CanonicalVolume, ClippedPolygonHoldsWhatIsInsideAndNothingElse) {
    std::mt19937 random(1);
    int kept = 0;
    for (int i = 0; i < 3'000; ++i) {
        const std::vector<Vec4> triangle = any_triangle(random, 4), clipped = clip_to_volume(triangle);
        kept += !clipped.empty();
        for (const Vec4& corner : clipped)
            for (const double distance : distances(corner)) ASSERT_GE(distance, -1e-8);
        for (const Real4& p : points_of(triangle)) {
            const bool is_inside = std::abs(p[0]) < p[3] && std::abs(p[1]) < p[3] && p[2] > 0 && p[2] < p[3];
            if (is_inside) expect_holds(clipped, p);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(kept, 500) << "the test clips something";
}

TEST(CanonicalVolume, PartsOfASplitTriangleAddUp) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> any(-3, 3);
    for (int i = 0; i < 3'000; ++i) {
        const std::vector<Vec4> triangle{corner(any(random), any(random)), corner(any(random), any(random)),
                                         corner(any(random), any(random))};
        for (const VolumeSide side : {VolumeSide::Left, VolumeSide::Right, VolumeSide::Bottom, VolumeSide::Top}) {
            const SplitPolygon split = split_polygon(triangle, side);
            ASSERT_NEAR(doubled_area(split.inside) + doubled_area(split.outside), doubled_area(triangle), 1e-7);
        }
    }
}

TEST(CanonicalVolume, CornersAtTheEndsOfTheFormatDoNotOverflow) {
    const Entry high = Entry::highest(), low = Entry::lowest();
    for (const Vec4& far : {Vec4{high, low, high, high}, Vec4{low, low, low, low}, Vec4{high, high, low, high}})
        for (const Vec4& p : clip_to_volume({corner(0, 0), far, corner(0.5, 0.5)})) EXPECT_EQ(volume_outcode(p), 0u);
}

TEST(VolumeMatrix, PutsTheViewsCornersOnTheVolumesCornersAndDepthsOn0And1) {
    const Projection projection = make_projection({320, 200, {4, 3}}, Degrees::from_int(90));
    const Matrix4 matrix = volume_matrix(projection, fixed_of<Entry>(4), fixed_of<Entry>(1000));
    // At depth 40 the view is 40 wide to each side, and 30 high: 4:3.
    const Vec4 at_corner = matrix * corner(40, 30, 40);
    EXPECT_NEAR(number_of(at_corner.x) / number_of(at_corner.w), 1, 1e-8);
    EXPECT_NEAR(number_of(at_corner.y) / number_of(at_corner.w), 1, 1e-8);
    EXPECT_NEAR(number_of(point_of(matrix * corner(0, 0, 4))->z), 0, 1e-8);
    EXPECT_NEAR(number_of(point_of(matrix * corner(0, 0, 1000))->z), 1, 1e-7);
}

TEST(VolumeMatrix, LeadsToTheScreenPositionsThatProjectGives) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1, 1);
    for (const ScreenMode& mode : {ScreenMode{320, 200, {4, 3}}, ScreenMode{640, 480, {16, 9}}}) {
        const Projection projection = make_projection(mode, Degrees::from_int(75));
        const Matrix4 matrix = volume_matrix(projection, fixed_of<Entry>(1), fixed_of<Entry>(500));
        for (int i = 0; i < 2'000; ++i) {
            const double z = 50 + 40 * any(random), x = z * any(random) / 2, y = z * any(random) / 2;
            const Vec3<View> p{fixed_of<View>(x), fixed_of<View>(y), fixed_of<View>(z)};
            const VolumeScreenPoint by_matrix =
                volume_to_screen(matrix * homogeneous(p), mode.width_px, mode.height_px);
            const ScreenPosition by_multipliers = project(p, projection);
            ASSERT_NEAR(number_of(by_matrix.x), number_of(by_multipliers.x), 0.003);
            ASSERT_NEAR(number_of(by_matrix.y), number_of(by_multipliers.y), 0.003);
        }
    }
}

}  // namespace
}  // namespace oblong::test::canonical_volume_test

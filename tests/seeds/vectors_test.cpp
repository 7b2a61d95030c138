#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/math/basis.h"
#include "engine/math/matrix.h"
#include "engine/math/vec.h"
#include "engine/methods/lines.h"
#include "engine/methods/square_root.h"
#include "engine/methods/transforms.h"
#include "tests/seeds/seed_values.h"
#include "tools/gallery/counted.h"

// What the five texts say of vectors, with the values as corrected. M: Muratori, N: the course notes, P: Princeton,
// A: Abrash.

namespace oblong::test {
namespace {

constexpr auto kOne = Unit::from_int(1);
constexpr Vec3<Unit> kUnitX{kOne, {}, {}}, kUnitY{{}, kOne, {}}, kUnitZ{{}, {}, kOne};

Vec3<World> at(std::int32_t x, std::int32_t y, std::int32_t z) {
    return {World::from_int(x), World::from_int(y), World::from_int(z)};
}

Vec3<Entry> entries(std::int64_t x, std::int64_t y, std::int64_t z) {
    return {entry(x), entry(y), entry(z)};
}

std::array<std::int64_t, 3> raw_of(const auto& v) {
    return {v.x.raw, v.y.raw, v.z.raw};
}
using Raw = std::array<std::int64_t, 3>;

std::int64_t dot_of(const Vec3<Entry>& a, const Vec3<Entry>& b) {
    return (multiply(a.x, b.x) + multiply(a.y, b.y) + multiply(a.z, b.z)).raw;
}

void expect_near(const Matrix4& a, const Matrix4& b) {
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            EXPECT_LE(std::abs(a.rows[i][j].raw - b.rows[i][j].raw), 64) << i << " " << j;
}

const Plane kFloorAt5 = plane_through(at(0, 0, 5), kUnitZ);

TEST(SeedA10, LightByADotProductTakesFourMultiplicationsAndTwoAdditions) {
    const auto light = []<class Number>(Number) {
        return lit(Vec3<Number>{0.6, 0, 0.8}, Vec3<Number>{0, 0, 1}, Number(200));
    };
    EXPECT_EQ(light(0.0), 160);
    EXPECT_EQ(operations_of([&] { light(Counted<double>(0)); }), (CountedOperations{4, 0, 2}));
}

TEST(SeedM6, LawOfCosinesTakesSquaredLengthsWithoutRoots) {
    const auto u = whole(1, 2, 3), v = whole(4, -5, 6);
    EXPECT_EQ((dot(u, u).raw + dot(v, v).raw - dot(u - v, u - v).raw) / 2, 12);
    EXPECT_EQ(dot(u, v).raw, 12);
    // What the listing says, with roots: 2.165635.
    const auto root = [](std::int64_t n) {
        return std::ldexp(square_root<Fixed<std::int64_t, 24>>(Fixed<std::int64_t, 0>{n}).raw, -24);
    };
    EXPECT_NEAR((root(14) + root(77) - root(dot(u - v, u - v).raw)) / 2, 2.165635, 1e-6);
}

TEST(SeedM7, LawOfCosinesHoldsForEveryPair) {
    for (std::int32_t i = 0; i < 1'000; ++i) {
        const auto u = whole(i % 10, i / 10 % 10 - 4, i / 100), v = whole(7 - i % 7, i % 13, i % 3 - 8);
        EXPECT_EQ(dot(u - v, u - v).raw, dot(u, u).raw + dot(v, v).raw - 2 * dot(u, v).raw);
    }
}

TEST(SeedM8, ComponentsMultiplyToADotProductInOrthonormalAxesOnly) {
    const auto i = whole(1, 0, 0), j = whole(1, 1, 0), components = whole(1, 1, 0);
    const auto a = i + j;
    EXPECT_EQ(dot(a, a).raw, 5) << "its squared length";
    EXPECT_EQ(dot(components, components).raw, 2) << "what its components in these crooked axes say";
    const Unit half = Unit::from_raw(1 << 29);
    EXPECT_FALSE(is_orthonormal({{half, {}, {}}, {half, half, {}}, kUnitZ})) << "i and j, halved";
}

TEST(SeedA1, LengthOf505Is5TimesTheRootOf2) {
    EXPECT_NEAR(std::ldexp(length(at(5, 0, 5)).raw, -12), 7.071067812, 0x1p-12);
    EXPECT_EQ(dot(whole(5, 0, 5), whole(5, 0, 5)).raw, 50);
}

TEST(SeedA2, LineMeetsPlaneInItsOwnThirdCoordinate) {
    // From (0, 0, 9) through (4, 2, 1): half way at z = 5. The listing starts its z from linestart[1].
    const auto hit = intersect_line(at(0, 0, 9), at(4, 2, 1), kFloorAt5);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->world_point, at(2, 1, 5));
}

TEST(SeedA3, StartInThePlaneIsTheAnswer) {
    const auto hit = intersect_line(at(1, 2, 5), at(3, 3, 9), kFloorAt5);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->world_point, at(1, 2, 5));  // not (1, 2, 2)
    EXPECT_EQ(hit->along.raw, 0);
}

TEST(SeedA4, ParallelLineMeetsNothing) {
    EXPECT_FALSE(intersect_line(at(0, 0, 7), at(4, 0, 7), kFloorAt5));
    EXPECT_FALSE(intersect_line(at(2, 2, 7), at(2, 2, 7), kFloorAt5)) << "a line of no length";
}

TEST(SeedA5, CrossProductOf123And456) {
    EXPECT_EQ(raw_of(cross(whole(1, 2, 3), whole(4, 5, 6))), (Raw{-3, 6, -3}));
}

TEST(SeedA6, CrossProductOfParallelVectorsIsNoNormal) {
    EXPECT_EQ(normalised(cross(whole(1, 2, 3), whole(-2, -4, -6))), Vec3<Unit>{});
}

TEST(SeedA7, NormalsNeedTheInverseTransposeUnderUnequalScale) {
    const auto normal = entries(1, 1, 0), tangent = entries(1, -1, 0);
    Matrix3 stretch = Matrix3::identity();
    stretch.rows[0][0] = Entry::from_int(2);
    EXPECT_EQ(dot_of(stretch * normal, stretch * tangent), Entry::from_int(3).raw) << "as the text has it";
    const auto turned = *normal_matrix(stretch) * normal;
    EXPECT_EQ(turned, (Vec3<Entry>{Entry::from_raw(std::int64_t{1} << 31), Entry::from_int(1), {}}));
    EXPECT_EQ(dot_of(turned, stretch * tangent), 0);
}

TEST(SeedA8, DistanceFromAPlaneIsADotProductWithItsNormal) {
    EXPECT_EQ(distance_to_plane(at(1, 2, 10), kFloorAt5), PlaneDistance::from_int(5));
}

TEST(SeedA9, VisibilityIsTheSignOfPointDotNormalNotOfTheNormalsZ) {
    const auto p = whole(10, 0, 10), q = whole(11, 0, 12), r = whole(10, 1, 10);
    const auto normal = cross(q - p, r - p);
    EXPECT_EQ(raw_of(normal), (Raw{-2, 0, 1})) << "seems to face away by z";
    EXPECT_EQ(10 * normal.x.raw + 0 * normal.y.raw + 10 * normal.z.raw, -10) << "but faces the viewer";
    // On a viewplane at distance 1, times 120: twice the area is -1, that is -0.008333.
    const auto twice_area = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
    EXPECT_NEAR(twice_area(11.0 / 12 - 1, 0, 0, 0.1), -0.008333, 1e-6);
}

TEST(SeedA11, CrossProductOfXAndYIsZInEitherHandedness) {
    EXPECT_EQ(raw_of(cross(kUnitX, kUnitY)), (Raw{0, 0, std::int64_t{1} << 60}));
}

TEST(SeedA12, EndsOnTheSameSideMeetNothingAndAnEndInThePlaneDoes) {
    EXPECT_FALSE(intersect_segment(at(0, 0, 6), at(9, 9, 8), kFloorAt5)) << "both in front: kept";
    EXPECT_FALSE(intersect_segment(at(0, 0, 4), at(9, 9, 2), kFloorAt5)) << "both behind: rejected";
    EXPECT_TRUE(intersect_segment(at(0, 0, 5), at(9, 9, 8), kFloorAt5));
    EXPECT_TRUE(intersect_segment(at(0, 0, 4), at(9, 9, 6), kFloorAt5));
    EXPECT_EQ(intersect_segment(at(0, 0, 1), at(3, 3, 5), kFloorAt5)->world_point, at(3, 3, 5));
    EXPECT_EQ(intersect_segment(at(3, 3, 5), at(0, 0, 5), kFloorAt5)->world_point, at(3, 3, 5)) << "lies in it";
}

TEST(SeedN7, FractionAlongTheLineIsD1OverD1MinusD2) {
    const auto hit = intersect_segment(at(0, 0, -1), at(0, 0, 3), plane_through(at(0, 0, 0), kUnitZ));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->along.raw, std::int64_t{1} << 30);  // 1/4
    EXPECT_EQ(hit->world_point, at(0, 0, 0));
}

TEST(SeedN9, LookAtRowsUndoTheColumnsOfItsAxesAndEye) {
    const auto eye = at(3, -7, 11);
    const Basis basis = look_at(eye, at(40, 25, -5), kUnitY, Handedness::Left);
    // By doubles: z is the direction of (37, 32, -16), x is y cross z, y completes them; the last column is -axis .
    // eye.
    const double length = std::sqrt(37.0 * 37 + 32 * 32 + 16 * 16), across = std::hypot(16.0, 37.0);
    const double z[] = {37 / length, 32 / length, -16 / length}, x[] = {-16 / across, 0, -37 / across};
    const double y[] = {z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]};
    const Matrix4 rows = view_matrix(basis, eye);
    std::size_t row = 0;
    for (const auto& axis : {x, y, z}) {
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(number_of(rows.rows[row][i]), axis[i], 1e-8) << row;
        const double along_eye = axis[0] * 3 + axis[1] * -7 + axis[2] * 11;
        EXPECT_NEAR(number_of(rows.rows[row][3]), -along_eye, 1e-7) << row;
        ++row;
    }
    expect_near(view_matrix(basis, eye) * camera_matrix(basis, eye), Matrix4::identity());
}

TEST(SeedP5, CameraMatrixHasAxesAndEyeForColumnsAndTheViewMatrixIsItsInverse) {
    const auto eye = at(3, -7, 11);
    const Basis basis = view_basis(Angle::from_bam(3'000), Angle::from_bam(-4'000), Angle::from_bam(500));
    const Matrix4 camera = camera_matrix(basis, eye), view = view_matrix(basis, eye);
    EXPECT_EQ(camera.rows[3], Matrix4::identity().rows[3]);
    const Vec4 eye_of_view = camera * Vec4{};
    EXPECT_EQ(*point_of(eye_of_view), entries(3, -7, 11));
    const auto undone = inverse(camera);
    ASSERT_TRUE(undone);
    expect_near(*undone, view);
}

}  // namespace
}  // namespace oblong::test

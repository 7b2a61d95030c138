// What seed 4 (Princeton) says of projection matrices, with the values as corrected. Its camera matrix:
// vectors_test.cpp.

#include <gtest/gtest.h>

#include <array>

#include "engine/fixed/trig.h"
#include "engine/math/vec.h"
#include "engine/methods/lines.h"
#include "engine/methods/transforms.h"
#include "tests/seeds/seed_values.h"

namespace oblong::test {
namespace {

TEST(SeedP1, LookingDownMinusZNeedsANegativeViewplaneDistance) {
    const Vec4 seen = point(entry(1), Entry{}, entry(-2));
    EXPECT_EQ(point_of(perspective(entry(-1)) * seen)->x, entry(1, 2));
    EXPECT_EQ(point_of(perspective(entry(1)) * seen)->x, entry(-1, 2)) << "as listed: mirrored";
}

TEST(SeedP2, ProjectedDepthIsTheViewplanesWhateverWasSeen) {
    for (const auto& [x, y, z] : {std::array{3, -5, 8}, {-7, 2, 16}, {0, 0, 4}, {9, 1, 1'024}}) {
        const Vec4 projected = perspective(entry(4)) * point(entry(x), entry(y), entry(z));
        EXPECT_EQ(*point_of(projected), (Vec3<Entry>{entry(4 * x, z), entry(4 * y, z), entry(4)}));
    }
}

TEST(SeedP3, ObliqueMatrixShiftsByDepthAlongTheAnglePhi) {
    struct Row {
        int degrees, per_z_2;  ///< L1 in halves: 2 cavalier, 1 cabinet
        double x, y;           ///< of (3, 5, 4)
    };
    for (const Row& row : {Row{0, 2, 7, 5}, Row{90, 2, 3, 9}, Row{60, 2, 5, 5 + 4 * 0.866025404},
                           Row{60, 1, 4, 5 + 2 * 0.866025404}, Row{180, 1, 1, 5}}) {
        const SineCosine60 phi = sine_cosine(Degrees::from_int(row.degrees));
        const Entry length = entry(row.per_z_2, 2);
        Matrix4 oblique = Matrix4::identity();
        oblique.rows[0][2] = multiply(length, convert<Entry>(phi.cosine));
        oblique.rows[1][2] = multiply(length, convert<Entry>(phi.sine));
        oblique.rows[2][2] = Entry{};
        const Vec3<Entry> shown = *point_of(oblique * point(entry(3), entry(5), entry(4)));
        EXPECT_NEAR(number_of(shown.x), row.x, 1e-8);
        EXPECT_NEAR(number_of(shown.y), row.y, 1e-8);
    }
}

TEST(SeedP4, QuadOfTheOpenGlListingIsPlanarAndOfAreaRoot2) {
    const auto at = [](int x, int y, int z) {
        return Vec3<World>{World::from_int(x), World::from_int(y), World::from_int(z)};
    };
    const std::array corners{at(0, 0, 0), at(1, 0, 0), at(1, 1, 1), at(0, 1, 1)};
    const auto doubled_area = cross(corners[2] - corners[0], corners[3] - corners[1]);  // of its diagonals
    const Plane plane = plane_through(corners[0], normalised(doubled_area));
    for (const auto& corner : corners) {
        EXPECT_EQ(distance_to_plane(corner, plane).raw, 0);
        EXPECT_EQ(corner.y, corner.z);
    }
    const std::uint64_t length_24 = length_of_raw({doubled_area.x.raw, doubled_area.y.raw, doubled_area.z.raw});
    EXPECT_NEAR(std::ldexp(static_cast<double>(length_24), -24) / 2, 1.414213562, 1e-7);
}

}  // namespace
}  // namespace oblong::test

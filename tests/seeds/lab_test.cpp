// What seed 2 (the lab report) says of the viewing pipeline, with the values as corrected. Every step is a matrix:
// view, scale to the canonical view volume, projection, screen.

#include <gtest/gtest.h>

#include <array>

#include "engine/math/matrix.h"
#include "engine/math/vec.h"
#include "engine/methods/canonical_volume.h"
#include "engine/methods/transforms.h"
#include "tests/seeds/seed_values.h"

namespace oblong::test {
namespace {

constexpr Vec3<Whole> kX = whole(1, 0, 0), kY = whole(0, 1, 0), kZ = whole(0, 0, 1);
constexpr std::int64_t kPictureSize = 200;

/// What the lab lets one choose. Lengths in units of the world; the window lies in the plane z = 0.
struct Lab {
    std::int64_t eye_distance = 4, window_size = 2;
    Entry eye_x = entry(1, 2), eye_y = entry(1, 2);  ///< where the eye stands before the window
    bool is_mirrored = true;                         ///< as the table of the cube has it
    bool scales_to_screen = true;                    ///< the lab's last step lacks it

    Matrix4 view() const {
        Matrix4 mirror = Matrix4::identity();
        if (is_mirrored) mirror.rows[0][0] = entry(-1);
        return mirror * translation({-eye_x, -eye_y, entry(eye_distance)});
    }
    /// Side planes to x = +-z, y = +-z: on the window half its size becomes its distance.
    Matrix4 canonical_scale() const {
        const Entry scale = entry(2 * eye_distance, window_size);
        return scaling({scale, scale, entry(1)});
    }
    /// [-d, d] to [0, size], rows downward.
    Matrix4 screen() const {
        const Entry scale = scales_to_screen ? entry(kPictureSize, 2 * eye_distance) : entry(1);
        return translation({entry(kPictureSize / 2), entry(kPictureSize / 2), Entry{}}) *
               scaling({scale, -scale, entry(1)});
    }
    Vec3<Entry> shown(Entry x, Entry y, Entry z) const {
        const Matrix4 projected = perspective(entry(eye_distance)) * canonical_scale() * view();
        const Vec3<Entry> on_window = *point_of(projected * point(x, y, z));
        return *point_of(screen() * point(on_window.x, on_window.y, on_window.z));
    }
    /// Pixels that a unit along x takes at depth z behind the window.
    double unit_length(std::int64_t z) const {
        return std::abs(number_of(shown(entry(1), Entry{}, entry(z)).x - shown(Entry{}, Entry{}, entry(z)).x));
    }
};

constexpr double kStep = 1e-6;

TEST(SeedL1, CubesFarFaceShrinksTowardTheCentre) {
    // 100 pixels from 150 to 50 at the window, 80 from 140 to 60 a unit behind it.
    for (const int x : {0, 1})
        for (const int y : {0, 1})
            for (const int z : {0, 1}) {
                const Vec3<Entry> shown = Lab{}.shown(entry(x), entry(y), entry(z));
                const int first = 150 - 10 * z, size = 100 - 20 * z;
                EXPECT_NEAR(number_of(shown.x), first - size * x, kStep) << x << y << z;
                EXPECT_NEAR(number_of(shown.y), first - size * y, kStep) << x << y << z;
            }
}

TEST(SeedL1b, FacesParallelToTheWindowScaleByDepthWhereverTheEyeStands) {
    for (const std::int64_t x : {-7, 0, 1, 30})
        for (const std::int64_t y : {-2, 0, 5}) {
            Lab lab;
            lab.eye_x = entry(x, 2);
            lab.eye_y = entry(y, 3);
            EXPECT_NEAR(lab.unit_length(0), 100, kStep);
            EXPECT_NEAR(lab.unit_length(1), 80, kStep);
        }
    // The table as listed keeps 100 pixels: it is an oblique parallel projection, x' = 150 - 100 x + 25 z.
    Matrix4 listed = Matrix4::identity();
    listed.rows[0] = {entry(-100), Entry{}, entry(25), entry(150)};
    const auto column = [&listed](int x, int z) { return number_of((listed * point(entry(x), Entry{}, entry(z))).x); };
    EXPECT_EQ(column(0, 1), 175);
    EXPECT_EQ(column(1, 1), 75);
    EXPECT_EQ(column(0, 1) - column(1, 1), column(0, 0) - column(1, 0));
}

TEST(SeedL1c, UpCrossViewDirectionIsToTheRightSoTheTableIsMirrored) {
    EXPECT_EQ(cross(kY, kZ).x.raw, kX.x.raw);
    EXPECT_EQ(cross(kY, -kZ).x.raw, -kX.x.raw);
    Lab upright;
    upright.is_mirrored = false;
    EXPECT_NEAR(number_of(upright.shown(Entry{}, Entry{}, Entry{}).x), 50, kStep);
    EXPECT_NEAR(number_of(Lab{}.shown(Entry{}, Entry{}, Entry{}).x), 150, kStep) << "the table's";
}

TEST(SeedL2, FiveStepsLeadToTheCanonicalViewVolume) {
    // Forward (3, 0, 4) / 5, right (-4, 0, 3) / 5, up y; the eye beside the window's middle, which is beside the VRP.
    WindowView window;
    const auto world = [](int x, int y, int z) {
        return Vec3<World>{World::from_int(x), World::from_int(y), World::from_int(z)};
    };
    window.reference_point = world(7, -2, 5);
    window.normal = world(-3, 0, -4);
    window.up = world(0, 5, 0);
    window.centre_of_projection = world(1, -4, -2);
    window.u_min = World::from_int(-1), window.u_max = World::from_int(4);
    window.v_min = World::from_int(-2), window.v_max = World::from_int(1);
    window.front = World::from_int(2), window.back = World::from_int(11);
    // From the VRP, the COP is (-6, -2, -7): along forward -46/5, along right 3/5, along up -2.
    const double d = 46.0 / 5, cop_u = 3.0 / 5, cop_v = -2, back = d + 11;
    const std::array<Matrix4, 5> steps = lab_volume_steps(window);
    Matrix4 whole = Matrix4::identity();
    std::array<Matrix4, 5> after;
    for (std::size_t i = 0; i < 5; ++i) after[i] = whole = steps[i] * whole;
    const auto expect_at = [](const Matrix4& matrix, double x, double y, double z, const std::array<double, 3>& to) {
        const Vec4 at = matrix * point(fixed_of<Entry>(x), fixed_of<Entry>(y), fixed_of<Entry>(z));
        EXPECT_NEAR(number_of(at.x), to[0], kStep);
        EXPECT_NEAR(number_of(at.y), to[1], kStep);
        EXPECT_NEAR(number_of(at.z), to[2], kStep);
        EXPECT_EQ(at.w, entry(1));
    };
    expect_at(after[0], 7, -2, 5, {0, 0, 0});
    expect_at(after[1], 7 + 3, -2, 5 + 4, {0, 0, 5});
    expect_at(after[1], 7 - 4, -2 + 1, 5 + 3, {5, 1, 0});
    expect_at(after[2], 1, -4, -2, {0, 0, 0});
    expect_at(after[2], 7, -2, 5, {-cop_u, -cop_v, d});
    for (const double depth : {0.0, 2.0, 11.0})
        for (const double u : {-1.0, 1.5, 4.0})
            for (const double v : {-2.0, -0.5, 1.0}) {
                // Where the ray through the window's (u, v) is at this depth.
                const double times = (d + depth) / d, right = cop_u + (u - cop_u) * times,
                             up = cop_v + (v - cop_v) * times;
                const double x = 7 + (-4 * right + 3 * depth) / 5, y = -2 + up, z = 5 + (3 * right + 4 * depth) / 5;
                const double at_z = d + depth;
                expect_at(after[3], x, y, z, {(u - 1.5) * times, (v + 0.5) * times, at_z});
                expect_at(after[4], x, y, z,
                          {(u - 1.5) / 2.5 * at_z / back, (v + 0.5) / 1.5 * at_z / back, at_z / back});
            }
}

TEST(SeedL2, ScaledWindowsEdgeLiesOnThePlaneXEqualsZ) {
    for (const std::int64_t window_size : {1, 2, 5, 16})
        for (const std::int64_t distance : {1, 3, 4, 20}) {
            Lab lab;
            lab.eye_distance = distance;
            lab.window_size = window_size;
            const Vec4 edge =
                lab.canonical_scale() * point(entry(window_size, 2), entry(-window_size, 2), entry(distance));
            EXPECT_NEAR(number_of(edge.x), static_cast<double>(distance), kStep);
            EXPECT_NEAR(number_of(edge.y), -static_cast<double>(distance), kStep);
            EXPECT_EQ(edge.z, entry(distance));
        }
}

TEST(SeedL3, ZOverDInTheLastPlaceIsAPointOnTheViewplane) {
    const Entry d = entry(4);
    for (const auto& [x, y, z] : {std::array{3, -5, 8}, {-7, 2, 16}, {1, 1, 4}}) {
        const Vec4 projected = perspective(d) * point(entry(x), entry(y), entry(z));
        EXPECT_EQ(projected.w, entry(z, 4));
        EXPECT_EQ(*point_of(projected), (Vec3<Entry>{entry(4 * x, z), entry(4 * y, z), d}));
    }
}

TEST(SeedL4, ScreenStepScalesByHalfTheSizeOverDBeforeItTranslates) {
    // The window's right edge, one unit beside the eye.
    const Entry edge = entry(3, 2), middle = entry(1, 2);
    Lab lab;
    lab.is_mirrored = false;
    EXPECT_NEAR(number_of(lab.shown(edge, middle, Entry{}).x), kPictureSize, kStep);
    lab.scales_to_screen = false;
    EXPECT_NEAR(number_of(lab.shown(edge, middle, Entry{}).x), kPictureSize / 2 + 4, kStep)
        << "d = 4 pixels off the centre";
}

TEST(SeedL5, SmallerWindowCropsAndOnlyAFartherEyeFlattens) {
    const auto lab_of = [](std::int64_t distance, std::int64_t window_size) {
        Lab lab;
        lab.eye_distance = distance;
        lab.window_size = window_size;
        return lab;
    };
    const auto near_to_far = [](const Lab& lab) { return lab.unit_length(2) / lab.unit_length(3); };
    EXPECT_NEAR(near_to_far(lab_of(2, 2)), 5.0 / 4, kStep);
    EXPECT_NEAR(near_to_far(lab_of(2, 1)), 5.0 / 4, kStep) << "half the window";
    EXPECT_NEAR(near_to_far(lab_of(20, 2)), 23.0 / 22, kStep);
    EXPECT_NEAR(lab_of(2, 1).unit_length(2), 2 * lab_of(2, 2).unit_length(2), kStep);
}

TEST(SeedL6, FartherEyeEnlargesWhatLiesBehindAFixedWindow) {
    // Two units behind the window, in units of the window: D / (D + 2).
    for (const auto& [distance, part] : {std::pair{2, 1.0 / 2}, {20, 10.0 / 11}}) {
        const Vec4 corner = perspective(entry(distance)) * point(entry(1), Entry{}, entry(distance + 2));
        EXPECT_NEAR(number_of(point_of(corner)->x), part, kStep);
    }
}

}  // namespace
}  // namespace oblong::test

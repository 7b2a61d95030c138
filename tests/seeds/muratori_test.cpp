// What seed 1 (Muratori) says of pixel aspect and projection, with the values as corrected. Its vectors:
// vectors_test.cpp.

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "engine/view/project.h"
#include "engine/view/projection.h"
#include "tests/seeds/seed_values.h"
#include "tools/gallery/counted.h"

namespace oblong::test {
namespace {

constexpr ScreenMode k320x200{320, 200, {4, 3}};

TEST(SeedM1, PixelsAspectIsWidthOverDisplayTimesHeight) {
    struct Row {
        ScreenMode mode;
        Ratio a;
    };
    for (const Row& row :
         {Row{k320x200, {6, 5}}, Row{{640, 480, {4, 3}}, {1, 1}}, Row{{320, 240, {4, 3}}, {1, 1}},
          Row{{640, 480, {37, 20}}, {80, 111}}, Row{{640, 400, {4, 3}}, {6, 5}}, Row{{1280, 1024, {4, 3}}, {15, 16}},
          Row{{360, 480, {4, 3}}, {9, 16}}, Row{{320, 200, {8, 5}}, {1, 1}}}) {
        EXPECT_EQ(row.mode.pixel(), row.a.inverse()) << row.mode.width_px << "x" << row.mode.height_px;
        const Projection projection = make_projection(row.mode, Degrees::from_int(90));
        const double y_scale = number_of(projection.y.multiplier) / number_of(projection.x.multiplier);
        EXPECT_NEAR(y_scale * static_cast<double>(row.a.numerator) / static_cast<double>(row.a.denominator), 1, 1e-9);
    }
}

TEST(SeedM2, PixelIsATimesAsHighAsWide) {
    const Ratio width_to_height = k320x200.pixel();
    EXPECT_EQ(width_to_height.inverse(), (Ratio{6, 5}));
    EXPECT_EQ(width_to_height, (Ratio{5, 6})) << "not wider than high, as the prose has it";
}

TEST(SeedM3, MultipliersAndVerticalFieldsOfViewOf60And90And120Degrees) {
    struct Row {
        int field_of_view;
        double x_multiplier, y_multiplier, vertical_field_of_view;
    };
    for (const Row& row : {Row{60, 277.128129211, 230.940107676, 46.826449}, Row{90, 160, 133.333333333, 73.739795},
                           Row{120, 92.376043070, 76.980035892, 104.821821}}) {
        const Projection projection = make_projection(k320x200, Degrees::from_int(row.field_of_view));
        EXPECT_NEAR(number_of(projection.x.multiplier), row.x_multiplier, 1e-9);
        EXPECT_NEAR(number_of(projection.y.multiplier), row.y_multiplier, 1e-9);
        const double half = std::atan(100 / number_of(projection.y.multiplier));
        EXPECT_NEAR(half * 360 / std::numbers::pi, row.vertical_field_of_view, 1e-6);
    }
}

TEST(SeedM3b, WidthCancelsFromTheMultiplierOfY) {
    for (const int degrees : {60, 90, 120}) {
        const auto y_multiplier = [degrees](std::int32_t width_px) {
            return number_of(make_projection({width_px, 200, {4, 3}}, Degrees::from_int(degrees)).y.multiplier);
        };
        const double expected = 4.0 / 3 * 200 / (2 * std::tan(degrees * std::numbers::pi / 360));
        for (const std::int32_t width_px : {200, 320, 333, 640, 1920})
            EXPECT_NEAR(y_multiplier(width_px), expected, 1e-8) << width_px;
    }
}

TEST(SeedM4, RowsGrowDownwardWhereYGrowsUpward) {
    const Projection projection = make_projection(k320x200, Degrees::from_int(90));
    const ScreenPosition above = project(view_point(0, 1, 4), projection),
                         below = project(view_point(0, -1, 4), projection);
    EXPECT_NEAR(number_of(above.y), 66.667, 1.0 / 256);
    EXPECT_NEAR(number_of(below.y), 133.333, 1.0 / 256) << "where the listed sign would put y = +1";
}

TEST(SeedM5, CentreIsHalfThePicturesHeightInPixelsWhateverTheDisplay) {
    for (const Ratio display : {Ratio{4, 3}, Ratio{16, 9}, Ratio{1, 1}}) {
        const Projection projection = make_projection({320, 200, display}, Degrees::from_int(90));
        const ScreenPosition ahead = project(view_point(0, 0, 4), projection);
        EXPECT_EQ(ahead.x, ScreenWide::from_int(160));
        EXPECT_EQ(ahead.y, ScreenWide::from_int(100));
    }
}

TEST(SeedM9, FourThirdsWrittenAs1Point33MissesByAQuarterOfAPixel) {
    EXPECT_EQ((ScreenMode{640, 480}.pixel() * Ratio{640, 480}), (Ratio{4, 3}));
    const ScreenMode rounded{320, 200, {133, 100}};
    EXPECT_EQ(rounded.pixel(), (Ratio{83'125, 100'000}));
    // What lies on the first row's upper border.
    const auto top = [](const ScreenMode& mode) {
        return number_of(project(view_point(0, 3, 4), make_projection(mode, Degrees::from_int(90))).y);
    };
    EXPECT_EQ(top(k320x200), 0);
    EXPECT_EQ(top(rounded), 0.25);
}

/// What the three projections of the seed do for one point, counted as they run, and that they end where project()
/// does.
TEST(SeedM10, AspectAndFieldOfViewInTwoMultipliersCostNothing) {
    const auto naively = []<class Number>(Number) {
        return project_naively(Vec3<Number>{3, 2, 7}, Number(160), SeedPixel<Number>{160, 100});
    };
    const auto by_formula = []<class Number>(Number) {
        return project_by_formula(Vec3<Number>{3, 2, 7}, Number(160), Number(4.0 / 3), SeedPixel<Number>{320, 200},
                                  SeedPixel<Number>{160, 100});
    };
    const auto by_multipliers = []<class Number>(Number) {
        return project_by_multipliers(Vec3<Number>{3, 2, 7}, SeedPixel<Number>{160, 400.0 / 3},
                                      SeedPixel<Number>{160, 100});
    };
    const Projection corrected = make_projection(k320x200, Degrees::from_int(90)),
                     square = make_projection(k320x200, Degrees::from_int(90), false);
    const auto expect = [](const auto& projected, const Projection& projection, const CountedOperations& operations) {
        const ScreenPosition position = project(view_point(3, 2, 7), projection);
        const SeedPixel<double> found = projected(0.0);
        EXPECT_NEAR(found.x, number_of(position.x), 1.0 / 256);
        EXPECT_NEAR(found.y, number_of(position.y), 1.0 / 256);
        EXPECT_EQ(operations_of([&] { projected(Counted<double>(0)); }), operations);
    };
    expect(naively, square, {2, 2, 2});
    expect(by_formula, corrected, {4, 3, 2});  // worked out at each point
    expect(by_multipliers, corrected, {2, 2, 2});
}

/// The seven things that the seed asks for, and the nine terms that they leave three of.
TEST(SeedM11, ThreeOfNineTermsAreLeftInOrthonormalAxesAlone) {
    const std::array<std::array<double, 3>, 3> orthonormal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        crooked{{{1, 0.5, 0}, {0.5, 1, 0}, {0, 0, 1}}};
    const Vec3<double> u{1, 2, 3}, v{4, -5, 6};
    EXPECT_EQ(dot_by_nine_terms(u, v, orthonormal), 12);
    EXPECT_EQ(dot_by_components(u, v), 12);
    // u is (2, root 3, 3) in axes at right angles, v (3/2, -5 root 3 / 2, 6): 3 - 15/2 + 18.
    EXPECT_EQ(dot_by_nine_terms(u, v, crooked), 13.5);
}

}  // namespace
}  // namespace oblong::test

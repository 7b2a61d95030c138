#include <gtest/gtest.h>

#include <cmath>

#include "engine/view/projection.h"
#include "game/lab/aspects.h"

namespace oblong::test::aspect_guide_test {
namespace {

constexpr ScreenMode kMode{320, 200, {4, 3}}, kSquarePixels{320, 240, {4, 3}}, kTallPixels{640, 200, {4, 3}};

std::string caption(WindowSize window, bool corrects_projection, ShownAs shown_as,
                    Scaling scaling = Scaling::SharpBilinear, const ScreenMode& mode = kMode) {
    return aspect_caption(mode, corrects_projection, shown_as, scaling, window);
}

// A pixel for 4:3 is 5:6. With square pixels a sphere of 6 x 6 becomes 6 x 5: 1/6 is missing.
TEST(AspectCaption, SaysWhatTheFourCombinationsDo) {
    constexpr WindowSize kWindow{1600, 1200};
    EXPECT_EQ(caption(kWindow, true, ShownAs::OnDisplay),
              "Drawn for 4:3, shown on 4:3:\nspheres round, the circle round");
    EXPECT_EQ(caption(kWindow, true, ShownAs::SquarePixels),
              "Drawn for 4:3, shown with square pixels:\nspheres 17 % too flat, the circle 17 % too flat");
    EXPECT_EQ(caption(kWindow, false, ShownAs::OnDisplay),
              "Drawn for square pixels, shown on 4:3:\nspheres 17 % too narrow, the circle round");
    EXPECT_EQ(caption(kWindow, false, ShownAs::SquarePixels),
              "Drawn for square pixels, shown with square pixels:\nspheres round, the circle 17 % too flat");
}

// On 16:9, pixels are 1920/320 x 1080/200 = 6 x 5.4: 10:9, which is 4:3 of what 5:6 should be.
TEST(AspectCaption, GoesByTheWindowWhereThePictureFillsIt) {
    constexpr WindowSize kWide{1920, 1080};
    const std::string flat =
        "Drawn for 4:3, shown in the window's shape:\nspheres 25 % too flat, the circle 25 % too flat";
    EXPECT_EQ(caption(kWide, true, ShownAs::FillWindow), flat);
    EXPECT_EQ(caption(kWide, false, ShownAs::FillWindow),
              "Drawn for square pixels, shown in the window's shape:\nspheres 10 % too flat, the circle 25 % too flat");
    EXPECT_EQ(caption({1600, 1200}, true, ShownAs::FillWindow),
              "Drawn for 4:3, shown in the window's shape:\nspheres round, the circle round");
}

// 1300x1000 has room for 4 rows and 3 columns a pixel: 3:4 is 9/10 of 5:6.
TEST(AspectCaption, CountsTheErrorOfWholePixels) {
    EXPECT_EQ(caption({1300, 1000}, true, ShownAs::OnDisplay, Scaling::Even),
              "Drawn for 4:3, shown on 4:3:\nspheres 10 % too narrow, the circle 10 % too narrow");
    EXPECT_EQ(caption({1300, 1000}, true, ShownAs::OnDisplay),
              "Drawn for 4:3, shown on 4:3:\nspheres round, the circle round");
}

TEST(AspectCaption, OtherModesHaveOtherErrors) {
    for (const bool corrects : {false, true})
        for (const ShownAs shown_as : {ShownAs::OnDisplay, ShownAs::SquarePixels}) {
            const std::string text = caption({640, 480}, corrects, shown_as, Scaling::SharpBilinear, kSquarePixels);
            EXPECT_NE(text.find("spheres round, the circle round"), std::string::npos) << text;
        }
    // Pixels of 640x200 are 5:12, so that square ones are 12/5 as wide: 7/12 of the height is missing.
    EXPECT_EQ(caption({1280, 960}, true, ShownAs::SquarePixels, Scaling::SharpBilinear, kTallPixels),
              "Drawn for 4:3, shown with square pixels:\nspheres 58 % too flat, the circle 58 % too flat");
    EXPECT_EQ(caption({}, false, ShownAs::OnDisplay),
              "Drawn for square pixels, shown on 4:3:\nspheres round, the circle 17 % too flat");  // no window
}

TEST(SphereShape, IsThatOfTheProjectionThatDraws) {
    for (const ScreenMode& mode : {kMode, kSquarePixels, kTallPixels, ScreenMode{480, 270, {16, 10}}})
        for (const bool corrects : {false, true}) {
            const Projection lens = make_projection(mode, Degrees::from_int(75), corrects);
            const double drawn =
                static_cast<double>(lens.x.multiplier.raw) / static_cast<double>(lens.y.multiplier.raw);
            const Ratio shape = sphere_shape(mode, corrects, {3, 2});
            EXPECT_NEAR(static_cast<double>(shape.numerator) / static_cast<double>(shape.denominator), drawn * 3 / 2,
                        1e-8);
        }
}

// Each pixel's centre is on the ellipse of that radius in columns and rows, to a pixel's diagonal; all of it is there.
TEST(Circle, FollowsTheEllipseOfThePixelsShape) {
    for (const ScreenMode& mode : {kMode, kSquarePixels, kTallPixels, ScreenMode{640, 400, {4, 3}}}) {
        const double pixel_height =
            static_cast<double>(mode.pixel().denominator) / static_cast<double>(mode.pixel().numerator);
        const double radius = 0.27 * std::min<double>(mode.width_px, mode.height_px * pixel_height);
        double widest = 0, highest = 0;
        for (const Pixel& at : circle_outline(mode)) {
            const double x = at.x + 0.5 - mode.width_px / 2.0, y = (at.y + 0.5 - mode.height_px / 2.0) * pixel_height;
            EXPECT_LE(std::abs(std::hypot(x, y) - radius), std::hypot(1, pixel_height));
            widest = std::max(widest, std::abs(x));
            highest = std::max(highest, std::abs(y));
        }
        EXPECT_NEAR(widest, radius, 1);
        EXPECT_NEAR(highest, radius, pixel_height);
        const Area square = true_square(mode);
        EXPECT_NEAR(square.width, square.height * pixel_height, (1 + pixel_height) / 2);
        EXPECT_GT(square.width, 2 * widest + 2);
    }
}

// Width to height of the picture as the window shows it.
double shown_shape(const AspectView& view, Ratio pixel) {
    return static_cast<double>(view.area.width * pixel.numerator) /
           static_cast<double>(view.area.height * pixel.denominator);
}

// In every window, the pictures for the display are 4:3 and the others 8:5, within half a pixel's rounding.
TEST(FourAspects, HaveTheirShapesInEveryWindow) {
    for (const Ratio pixel : {Ratio{5, 6}, Ratio{1, 1}, Ratio{10, 9}, Ratio{1, 2}, Ratio{3, 1}})
        for (const AspectView& view : four_aspects(kMode, pixel)) {
            const double wanted = view.corrects_display ? 4.0 / 3 : 8.0 / 5;
            EXPECT_NEAR(shown_shape(view, pixel), wanted, wanted * 1.0 / std::min(view.area.width, view.area.height));
            EXPECT_TRUE(view.area.width == view.cell.width || view.area.height == view.cell.height);
            EXPECT_GE(view.area.x, view.cell.x);
            EXPECT_LE(view.area.x + view.area.width, view.cell.x + view.cell.width);
            EXPECT_LE(view.area.y + view.area.height, view.cell.y + view.cell.height);
        }
}

// What is seen above and below depends on the projection alone: tan of half the vertical angle is 3/4 and 5/8 of
// that across.
TEST(FourAspects, ShowAsMuchAsTheWholePicture) {
    for (const AspectView& view : four_aspects({320, 200, {4, 3}}, {5, 6})) {
        const Projection lens = make_projection(view.mode, Degrees::from_int(90));
        const double half_height = view.mode.height_px / 2.0 / (static_cast<double>(lens.y.multiplier.raw) / 0x1p32);
        EXPECT_NEAR(half_height, view.corrects_projection ? 3.0 / 4 : 5.0 / 8, 1e-6);
    }
}

TEST(FourAspects, SayWhatEachIs) {
    std::string all;
    for (const AspectView& view : four_aspects(kMode, {5, 6})) all += caption_of(view, kMode) + ";";
    EXPECT_EQ(all,
              "drawn and shown 4:3:\nround;drawn square, shown 4:3:\n17 % too narrow;"
              "drawn 4:3, shown square:\n17 % too flat;drawn and shown square:\nround;");
}

}  // namespace
}  // namespace oblong::test::aspect_guide_test

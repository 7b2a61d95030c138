#include <gtest/gtest.h>

#include "game/lab/aspects.h"

namespace oblong::test::four_aspects_test {
namespace {

// Width to height of the picture as the window shows it.
double shown_shape(const AspectView& view, Ratio pixel) {
    return static_cast<double>(view.area.width * pixel.numerator) /
           static_cast<double>(view.area.height * pixel.denominator);
}

// In every window, the pictures for the display are 4:3 and the others 8:5, within half a pixel's rounding.
TEST(FourAspects, HaveTheirShapesInEveryWindow) {
    constexpr ScreenMode kMode{320, 200, {4, 3}};
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
    constexpr ScreenMode kMode{320, 200, {4, 3}};
    std::string all;
    for (const AspectView& view : four_aspects(kMode, {5, 6})) all += caption_of(view, kMode) + ";";
    EXPECT_EQ(all,
              "drawn and shown 4:3:\nround;drawn square, shown 4:3:\n17 % too narrow;"
              "drawn 4:3, shown square:\n17 % too flat;drawn and shown square:\nround;");
}

}  // namespace
}  // namespace oblong::test::four_aspects_test

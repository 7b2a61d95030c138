#include "engine/view/present_rect.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace oblong {
namespace {

constexpr ScreenMode kMode{};  // 320x200 on 4:3

struct Expected {
    WindowSize window, sharp, even, rows;
    const char* even_text;
};

// The sizes that users of such programs have asked for; widths are 4/3 of the height, rounded, worked out by hand.
const std::array<Expected, 6> kDisplays{{
    {{1280, 800}, {1067, 800}, {960, 800}, {1067, 800}, "3:4, -10.0 %"},
    {{1920, 1080}, {1440, 1080}, {1280, 1000}, {1333, 1000}, "4:5, -4.0 %"},
    {{1600, 1200}, {1600, 1200}, {1600, 1200}, {1600, 1200}, "5:6"},
    {{1920, 1200}, {1600, 1200}, {1600, 1200}, {1600, 1200}, "5:6"},
    {{2560, 1440}, {1920, 1440}, {1920, 1400}, {1867, 1400}, "6:7, +2.9 %"},
    {{3840, 2160}, {2880, 2160}, {2560, 2000}, {2667, 2000}, "8:10, -4.0 %"},
}};

WindowSize size_of(const PresentRect& rect) {
    return {rect.width_px, rect.height_px};
}

void expect_size(WindowSize is, WindowSize wanted, WindowSize window, Scaling scaling) {
    EXPECT_EQ(is.width_px, wanted.width_px) << name_of(scaling) << " in " << window.width_px;
    EXPECT_EQ(is.height_px, wanted.height_px) << name_of(scaling) << " in " << window.width_px;
}

TEST(Layout, KnownDisplays) {
    for (const Expected& display : kDisplays) {
        const auto shown = [&](Scaling scaling) { return layout(display.window, kMode, ShownAs::OnDisplay, scaling); };
        expect_size(size_of(shown(Scaling::SharpBilinear)), display.sharp, display.window, Scaling::SharpBilinear);
        expect_size(size_of(shown(Scaling::Nearest)), display.sharp, display.window, Scaling::Nearest);
        expect_size(size_of(shown(Scaling::Even)), display.even, display.window, Scaling::Even);
        expect_size(size_of(shown(Scaling::Rows)), display.rows, display.window, Scaling::Rows);
        const PresentRect filled = layout(display.window, kMode, ShownAs::FillWindow, Scaling::SharpBilinear);
        expect_size(size_of(filled), display.window, display.window, Scaling::SharpBilinear);
        EXPECT_EQ(describe(shown(Scaling::Even), kMode), display.even_text);
    }
}

TEST(Layout, FiveBySixIsExactAndBlendsNothing) {
    const PresentRect rect = layout({1600, 1200}, kMode, ShownAs::OnDisplay, Scaling::SharpBilinear);
    EXPECT_EQ(rect.upscale_x, 5);
    EXPECT_EQ(rect.upscale_y, 6);
    EXPECT_FALSE(rect.is_blended);
}

TEST(Layout, SharpUpscalesToTheNextWholeMultipleOfEachAxis) {
    const PresentRect rect = layout({1920, 1080}, kMode, ShownAs::OnDisplay, Scaling::SharpBilinear);
    EXPECT_EQ(rect.upscale_x, 5);  // 4.5
    EXPECT_EQ(rect.upscale_y, 6);  // 5.4
    EXPECT_TRUE(rect.is_blended);
    EXPECT_EQ(rect.x_px, 240);
    EXPECT_EQ(rect.y_px, 0);
    EXPECT_EQ(describe(rect, kMode), "x 4.50, y 5.40");
}

TEST(Layout, NoPairWithinTenPercentShowsItsError) {
    for (const WindowSize window : {WindowSize{1280, 720}, WindowSize{1366, 768}}) {
        const PresentRect rect = layout(window, kMode, ShownAs::OnDisplay, Scaling::Even);
        EXPECT_GT(std::abs(rect.shape_error_permille), 100);
    }
}

/// A real 4:3 tube run at 640x400 or 1280x1024 must be filled.
TEST(Layout, OtherModesDisplaysAndWaysToShow) {
    const ScreenMode vga{640, 480, {4, 3}}, projector{640, 480, {37, 20}}, tube{640, 400, {4, 3}};
    struct Row {
        ScreenMode mode;
        ShownAs shown;
        Scaling scaling;
        WindowSize window, wanted;
    };
    for (const Row& row : {Row{kMode, ShownAs::SquarePixels, Scaling::SharpBilinear, {1600, 1200}, {1600, 1000}},
                           {kMode, ShownAs::FillWindow, Scaling::SharpBilinear, {640, 400}, {640, 400}},
                           {kMode, ShownAs::FillWindow, Scaling::SharpBilinear, {1280, 1024}, {1280, 1024}},
                           {vga, ShownAs::OnDisplay, Scaling::SharpBilinear, {1920, 1080}, {1440, 1080}},
                           {projector, ShownAs::OnDisplay, Scaling::SharpBilinear, {1850, 1200}, {1850, 1000}},
                           // 2:3 of 5:6: -20 %, as 2.5 columns are none
                           {tube, ShownAs::OnDisplay, Scaling::Even, {1600, 1200}, {1280, 1200}}})
        expect_size(size_of(layout(row.window, row.mode, row.shown, row.scaling)), row.wanted, row.window, row.scaling);
}

bool is_inside(const PresentRect& rect, WindowSize window) {
    return rect.x_px >= 0 && rect.y_px >= 0 && rect.width_px >= 1 && rect.height_px >= 1 &&
           rect.x_px + rect.width_px <= window.width_px && rect.y_px + rect.height_px <= window.height_px;
}

TEST(Layout, HostileWindowsStayInside) {
    constexpr std::array<std::int32_t, 9> sides{1, 2, 199, 200, 201, 319, 321, 4097, 32767};
    const std::array<ScreenMode, 4> modes{ScreenMode{}, ScreenMode{1, 1, {1, 1}}, ScreenMode{4096, 4096, {4096, 1}},
                                          ScreenMode{4096, 1, {1, 4096}}};
    for (const ScreenMode& mode : modes)
        for (const std::int32_t width : sides)
            for (const std::int32_t height : sides)
                for (int shown = 0; shown < kShownAsCount; ++shown)
                    for (int scaling = 0; scaling < kScalingCount; ++scaling)
                        ASSERT_TRUE(is_inside(
                            layout({width, height}, mode, static_cast<ShownAs>(shown), static_cast<Scaling>(scaling)),
                            {width, height}))
                            << width << "x" << height << " " << scaling;
}

TEST(Layout, NothingIsShownInNothing) {
    constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
    for (const WindowSize window : {WindowSize{0, 0}, WindowSize{0, 100}, WindowSize{100, 0}, WindowSize{-5, 7}})
        EXPECT_EQ(layout(window, kMode, ShownAs::OnDisplay, Scaling::SharpBilinear), PresentRect{});
    EXPECT_TRUE(is_inside(layout({most, most}, kMode, ShownAs::OnDisplay, Scaling::Even), {most, most}));
}

// A circle of the world is as wide as high in the window: the rectangle's shape is the display's to half a pixel.
TEST(Layout, ShapeIsExactToHalfAPixelExceptForEven) {
    for (std::int32_t width = 320; width < 2000; width += 37)
        for (const Scaling scaling : {Scaling::SharpBilinear, Scaling::Nearest, Scaling::Rows}) {
            const PresentRect rect = layout({width, 1000}, kMode, ShownAs::OnDisplay, scaling);
            const double off_px = std::min(std::abs(rect.width_px - rect.height_px * 4.0 / 3),
                                           std::abs(rect.height_px - rect.width_px * 0.75));
            EXPECT_LE(off_px, 0.5) << width << " " << name_of(scaling);
        }
}

}  // namespace
}  // namespace oblong

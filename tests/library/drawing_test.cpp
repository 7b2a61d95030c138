#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/library/oblong.h"
#include "tests/support/folders.h"
#include "tests/support/palettes.h"

namespace oblong {
namespace {

constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min(),
                       kMost = std::numeric_limits<std::int32_t>::max();

// What is drawn in a canvas of one colour, by the places that have another.
Picture drawn_in(std::int32_t width, std::int32_t height, auto draw) {
    Picture picture = Picture::of_size(width, height);
    draw(picture.canvas());
    return picture;
}

class LibraryCircle : public testing::TestWithParam<ScreenMode> {};

// In doubles: a pixel is inside where its middle is less than radius + 1/2 columns away on the display.
TEST_P(LibraryCircle, IsRoundOnTheDisplay) {
    const ScreenMode mode = GetParam();
    const double shape = static_cast<double>(mode.display.numerator) / static_cast<double>(mode.display.denominator) *
                         mode.height_px / mode.width_px;
    for (const int radius : {0, 1, 7, 60, 99}) {
        const int x = mode.width_px / 2, y = mode.height_px / 2;
        Picture filled = drawn_in(mode.width_px, mode.height_px,
                                  [&](Framebuffer canvas) { fill_circle(canvas, mode, x, y, radius, 1); });
        int most_rows = 0;
        for (int row = 0; row < mode.height_px; ++row)
            for (int column = 0; column < mode.width_px; ++column) {
                const double distance = std::hypot(column - x, (row - y) / shape);
                if (std::abs(distance - radius - 0.5) < 1e-9) continue;
                ASSERT_EQ(pixel_at(filled.canvas(), column, row), distance < radius + 0.5) << column << ", " << row;
                most_rows = std::max(most_rows, pixel_at(filled.canvas(), column, row) * std::abs(row - y));
            }
        EXPECT_NEAR(most_rows / shape, radius, 0.5 + 1 / shape);
    }
}

// Of a circle far off the canvas, only the rows of the canvas are walked; they are those of a canvas that has all of
// it.
TEST_P(LibraryCircle, OnAPartIsThatOfTheWhole) {
    ScreenMode mode = GetParam();
    const int radius = 500;
    for (const bool is_filled : {true, false}) {
        const auto draw = [&](Framebuffer canvas, int x, int y) {
            is_filled ? fill_circle(canvas, mode, x, y, radius, 1) : draw_circle(canvas, mode, x, y, radius, 1);
        };
        Picture whole = drawn_in(1200, 2400, [&](Framebuffer canvas) { draw(canvas, 600, 1200); });
        for (const int top : {0, 690, 1190, 1500}) {
            Picture part = drawn_in(1200, 20, [&](Framebuffer canvas) { draw(canvas, 600, 1200 - top); });
            EXPECT_TRUE(std::equal(part.pixels.begin(), part.pixels.end(), whole.pixels.begin() + top * 1200)) << top;
        }
    }
}

// A path of neighbours along the border of the filled one, which has no pixel outside it.
TEST_P(LibraryCircle, LineIsTheBorderOfTheFilledOneWithoutGaps) {
    const ScreenMode mode = GetParam();
    const int x = mode.width_px / 2, y = mode.height_px / 2, radius = 80;
    Picture filled = drawn_in(mode.width_px, mode.height_px,
                              [&](Framebuffer canvas) { fill_circle(canvas, mode, x, y, radius, 1); });
    Picture line = drawn_in(mode.width_px, mode.height_px,
                            [&](Framebuffer canvas) { draw_circle(canvas, mode, x, y, radius, 1); });
    const auto is_inside = [&](int column, int row) { return pixel_at(filled.canvas(), column, row) == 1; };
    for (int row = 0; row < mode.height_px; ++row)
        for (int column = 0; column < mode.width_px; ++column) {
            const bool is_drawn = pixel_at(line.canvas(), column, row) == 1;
            if (is_drawn) {
                ASSERT_TRUE(is_inside(column, row)) << column << ", " << row;
            }
            const bool is_border =
                is_inside(column, row) && (!is_inside(column - 1, row) || !is_inside(column + 1, row) ||
                                           !is_inside(column, row - 1) || !is_inside(column, row + 1));
            if (is_border) {
                ASSERT_TRUE(is_drawn) << column << ", " << row;
            }
        }
}

INSTANTIATE_TEST_SUITE_P(Modes, LibraryCircle,
                         testing::Values(ScreenMode{}, ScreenMode{320, 240, {4, 3}}, ScreenMode{640, 200, {4, 3}},
                                         ScreenMode{640, 480, {185, 100}}));

TEST(LibraryTriangle, FanCoversItsPolygonOnce) {
    const std::vector<PixelPosition> around{{10, 50}, {60, 5}, {150, 30}, {170, 120}, {90, 180}, {20, 140}};
    const PixelPosition middle{80, 90};
    std::vector<int> covered(200 * 200);
    for (std::size_t i = 0; i < around.size(); ++i) {
        Picture one = drawn_in(200, 200, [&](Framebuffer canvas) {
            // Either way round.
            const PixelPosition next = around[(i + 1) % around.size()];
            i % 2 == 0 ? fill_triangle(canvas, middle, around[i], next, 1)
                       : fill_triangle(canvas, middle, next, around[i], 1);
        });
        for (std::size_t at = 0; at < covered.size(); ++at) covered[at] += one.pixels[at];
    }
    // The polygon in doubles: left of none of its sides.
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            double least = 1e9;
            for (std::size_t i = 0; i < around.size(); ++i) {
                const PixelPosition a = around[i], b = around[(i + 1) % around.size()];
                least =
                    std::min(least, double(b.column - a.column) * (y - a.row) - double(b.row - a.row) * (x - a.column));
            }
            if (least > 0) {
                ASSERT_EQ(covered[as_size(y * 200 + x)], 1) << x << ", " << y;
            }
            if (least < 0) {
                ASSERT_EQ(covered[as_size(y * 200 + x)], 0) << x << ", " << y;
            }
        }
}

TEST(LibraryPicture, QuarterTurnsMoveEachPixelToItsPlace) {
    Picture picture = Picture::of_size(5, 3);
    for (std::size_t i = 0; i < 15; ++i) picture.pixels[i] = static_cast<std::uint8_t>(i + 1);
    const auto turned = [&](int degrees) {
        return drawn_in(21, 21, [&](Framebuffer canvas) { draw_turned(canvas, picture, 10, 10, degrees * 256); });
    };
    const auto at = [&](int column, int row) { return static_cast<int>(picture.pixels[as_size(row * 5 + column)]); };
    Picture none = turned(0), quarter = turned(90), half = turned(180);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 5; ++column) {
            const int right = column - 2, down = row - 1;
            EXPECT_EQ(pixel_at(none.canvas(), 10 + right, 10 + down), at(column, row));
            EXPECT_EQ(pixel_at(half.canvas(), 10 - right, 10 - down), at(column, row));
            // Counter-clockwise: what was right is up.
            EXPECT_EQ(pixel_at(quarter.canvas(), 10 + down, 10 - right), at(column, row));
        }
}

TEST(LibraryPicture, TransparentPixelsShowWhatIsBehind) {
    Picture picture = Picture::of_size(4, 1);
    picture.pixels = {7, kTransparent, 9, kTransparent};
    Picture shown = drawn_in(6, 3, [&](Framebuffer canvas) {
        clear(canvas, 3);
        draw_picture(canvas, picture, -1, 1);
        draw_picture(canvas, picture, 4, 2);
    });
    const std::vector<std::uint8_t> expected{3, 3, 3, 3, 3, 3, 3, 9, 3, 3, 3, 3, 3, 3, 3, 3, 7, 3};
    EXPECT_EQ(shown.pixels, expected);
}

// Each pixel of the sheet is its own colour; a part of it reaches beyond its right side.
TEST(LibraryPicture, PartsAreTurnedOverAndCutOff) {
    Picture sheet = Picture::of_size(4, 2);
    sheet.pixels = {1, 2, 3, kTransparent, 5, 6, 7, 8};
    const auto shown = [&](const PicturePart& part, int x, int y) {
        return drawn_in(4, 2, [&](Framebuffer canvas) { draw_part(canvas, sheet, part, x, y); }).pixels;
    };
    using Pixels = std::vector<std::uint8_t>;
    EXPECT_EQ(shown({1, 0, 3, 2}, 0, 0), (Pixels{2, 3, 0, 0, 6, 7, 8, 0}));
    EXPECT_EQ(shown({1, 0, 3, 2, true}, 0, 0), (Pixels{0, 3, 2, 0, 8, 7, 6, 0}));
    EXPECT_EQ(shown({1, 0, 3, 2, false, true}, 0, 0), (Pixels{6, 7, 8, 0, 2, 3, 0, 0}));
    EXPECT_EQ(shown({1, 0, 3, 2, false, false, true}, 0, 0), (Pixels{2, 3, kTransparent, 0, 6, 7, 8, 0}));
    EXPECT_EQ(shown({0, 1, 2, 1, true, false, false, 2}, 0, 0), (Pixels{6, 6, 5, 5, 6, 6, 5, 5}));
    EXPECT_EQ(shown({1, 0, 3, 2, false, false, false, 2}, -3, -1), (Pixels{3, 0, 0, 0, 7, 8, 8, 0}));
    EXPECT_EQ(shown({2, 1, 3, 1, true}, 0, 0), (Pixels{0, 8, 7, 0, 0, 0, 0, 0})) << "nothing beyond the sheet";
    EXPECT_EQ(shown({1, 0, 3, 2}, -2, 1), (Pixels{0, 0, 0, 0, 0, 0, 0, 0})) << "off the canvas, or transparent";
    EXPECT_EQ(shown({0, 0, 2, 2}, 3, -1), (Pixels{0, 0, 0, 5, 0, 0, 0, 0}));
    EXPECT_EQ(shown({kLeast, kMost, kMost, kMost, true, true, true}, 0, 0), Pixels(8));
}

// An uncompressed TGA of two by two pixels of blue, green, red, alpha; the first row at the bottom.
TEST(LibraryPicture, FileOfColoursGetsThePalettesNearestAndItsHoles) {
    const test::TemporaryFolder folder;
    const std::vector<std::uint8_t> tga{0,  0, 2, 0,   0,  0,  0,  0,   0,  0,  0,  0,   2,   0,   2,   0,
                                        32, 8,                                                               // header
                                        9,  9, 9, 255, 40, 40, 41, 128, 80, 80, 80, 127, 200, 199, 200, 0};  // pixels
    const Picture picture = load_picture(folder.write("four.tga", tga), test::grey_palette());
    EXPECT_EQ(picture.pixels, (std::vector<std::uint8_t>{kTransparent, kTransparent, 9, 40}));
}

// Rows of the canvas are a part of a larger picture, whose other pixels stay.
TEST(LibraryDrawing, NothingIsDrawnOutsideOfACanvas) {
    Picture whole = Picture::of_size(64, 48), picture = Picture::of_size(9, 9);
    picture.pixels.assign(81, 5);
    const Framebuffer canvas{whole.pixels.data() + 16 * 64 + 16, 32, 16, 64};
    for (const std::int32_t x : {kLeast, -40, -1, 0, 31, 32, 80, kMost})
        for (const std::int32_t y : {kLeast, -40, -1, 0, 15, 16, 80, kMost}) {
            set_pixel(canvas, x, y, 1);
            pixel_at(canvas, x, y);
            for (const std::int32_t size : {kLeast, -1, 0, 1, 40, kMost}) {
                draw_rectangle(canvas, x, y, size, size, 1);
                fill_rectangle(canvas, x, y, size, 7, 1);
                draw_circle(canvas, {}, x, y, size, 1);
                fill_circle(canvas, {}, x, y, size, 1);
                draw_line(canvas, x, y, size, y, 1);
                fill_triangle(canvas, {x, y}, {size, 3}, {8, size}, 1);
                draw_turned(canvas, picture, x, y, size, std::min(size, 4096));
                draw_label(canvas, x, y, "Some", 1, size);
            }
            draw_picture(canvas, picture, x, y);
        }
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            if (x < 16 || x >= 48 || y < 16 || y >= 32) {
                ASSERT_EQ(pixel_at(whole.canvas(), x, y), 0) << x << ", " << y;
            }
}

TEST(LibraryDrawing, ARectangleAroundEverythingFillsTheCanvas) {
    Picture picture = Picture::of_size(8, 8);
    fill_rectangle(picture.canvas(), -(1 << 30), -(1 << 30), kMost, kMost, 1);
    EXPECT_EQ(std::count(picture.pixels.begin(), picture.pixels.end(), 1), 64);
}

TEST(LibraryDrawing, ACircleOfAModeThatNoWindowHasIsRefused) {
    Picture picture = Picture::of_size(8, 8);
    for (const ScreenMode mode : {ScreenMode{0, 200, {4, 3}}, ScreenMode{320, 200, {4, 0}}}) {
        EXPECT_THROW(draw_circle(picture.canvas(), mode, 4, 4, 2, 1), std::runtime_error);
        EXPECT_THROW(fill_circle(picture.canvas(), mode, 4, 4, 2, 1), std::runtime_error);
    }
}

TEST(LibraryDrawing, ALabelIsInUtf8) {
    Picture shown = Picture::of_size(16, 10), expected = Picture::of_size(16, 10);
    draw_label(shown.canvas(), 1, 2, "É\xff", 5);
    for (const PixelPosition dot : {PixelPosition{4, 0}, {3, 1}, {1, 4}, {1, 5}, {1, 7}})
        set_pixel(expected.canvas(), dot.column, dot.row, 5);
    for (const PixelPosition end : {PixelPosition{5, 3}, {4, 6}, {5, 8}})
        draw_line(expected.canvas(), 1, end.row, end.column, end.row, 5);
    draw_label(expected.canvas(), 7, 2, "?", 5);
    EXPECT_EQ(shown.pixels, expected.pixels);
}

TEST(LibraryPicture, OfAnotherNumberOfPixelsIsRefused) {
    Picture canvas = Picture::of_size(8, 8);
    for (Picture picture : {Picture{2, 2, {}}, Picture{2, 2, {1, 2, 3}}, Picture{2, 1, {1, 2, 3}}}) {
        EXPECT_THROW(picture.canvas(), std::runtime_error);
        EXPECT_THROW(draw_picture(canvas.canvas(), picture, 0, 0), std::runtime_error);
        EXPECT_THROW(draw_turned(canvas.canvas(), picture, 0, 0, 0), std::runtime_error);
    }
    EXPECT_NO_THROW(draw_picture(canvas.canvas(), {}, 0, 0));
}

TEST(LibraryDrawing, LinesAreAsWideAsTheirLabels) {
    const std::string text = "A fox runs\nhome";
    EXPECT_EQ(wrapped(text, text_width_px("A fox")), (std::vector<std::string>{"A fox", "runs", "home"}));
    Picture shown = drawn_in(100, 10, [](Framebuffer canvas) { draw_label(canvas, 0, 0, "HH", 1); });
    int right = 0;
    for (int x = 0; x < 100; ++x)
        if (pixel_at(shown.canvas(), x, 4) == 1) right = x;
    EXPECT_EQ(text_width_px("HH"), right + 2) << "with the space behind a letter";
}

}  // namespace
}  // namespace oblong

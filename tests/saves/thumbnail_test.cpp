#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "game/saves/saved_game.h"
#include "tests/support/palettes.h"

namespace oblong::test {
namespace {

struct Canvas {
    Canvas(std::int32_t width_px, std::int32_t height_px, std::uint8_t colour = 0)
        : pixels(pixel_count(width_px, height_px), colour), picture{pixels.data(), width_px, height_px, width_px} {}
    std::vector<std::uint8_t> pixels;
    Framebuffer picture;
};

std::uint8_t pixel(const Thumbnail& thumbnail, std::size_t x, std::size_t y) {
    return thumbnail.pixels[y * 80 + x].green;
}

TEST(Thumbnail, HasTheMeanOfWhatEachPixelCovers) {
    Canvas canvas(320, 200);
    for (std::int32_t y = 0; y < 200; ++y)
        for (std::int32_t x = 0; x < 320; ++x)
            canvas.picture.row(y)[x] = static_cast<std::uint8_t>(x / 4 + 2 * (y / 4) + (x % 2 == 0 ? 20 : 0));
    const Thumbnail thumbnail = make_thumbnail(canvas.picture, grey_palette());
    for (std::size_t y = 0; y < 50; ++y)
        for (std::size_t x = 0; x < 80; ++x) ASSERT_EQ(pixel(thumbnail, x, y), x + 2 * y + 10);
}

TEST(Thumbnail, IsOfTheWholePictureInAnyMode) {
    for (const auto& [width, height] : {std::pair{8, 8}, {320, 200}, {333, 217}, {79, 51}, {640, 480}}) {
        Canvas canvas(width, height, 7);
        canvas.picture.row(height - 1)[width - 1] = 255;
        canvas.picture.row(0)[0] = 254;
        const Thumbnail thumbnail = make_thumbnail(canvas.picture, grey_palette());
        EXPECT_GT(pixel(thumbnail, 0, 0), 7) << width;
        EXPECT_GT(pixel(thumbnail, 79, 49), 7) << width;
        EXPECT_EQ(pixel(thumbnail, 40, 25), 7) << width;
    }
}

TEST(Thumbnail, IsOfTheColoursNotTheirNumbers) {
    Canvas canvas(160, 100, 9);
    Palette palette;
    palette.colours[9] = {10, 20, 30};
    EXPECT_EQ(make_thumbnail(canvas.picture, palette).pixels.front(), (Rgb8{10, 20, 30}));
}

}  // namespace
}  // namespace oblong::test

// Coloured light in frames: the more steps it has, the nearer pixels are to their true colours.

#include <cmath>

#include "engine/reference/colour.h"
#include "tests/effect_frames/effect_stage.h"

namespace oblong::test {
namespace {

std::string hall_of_lamps() {
    return entity("worldspawn", {},
                  room({-256, -256, 0}, {256, 256, 192}) + box({40, -60, 0}, {100, 60, 90}, "other")) +
           entities_of(
               "info_player_start -100 0 64 + light -40 200 100 light=350 _color='255 60 30' + light -40 -200 60 "
               "light=350 _color='40 90 255' + light 150 0 150 light=350 _color='60 255 90'");
}

/// 6 x 6 x 6 colours, with which the textures' are light greys.
Colormap even_colormap() {
    Palette palette = even_colours();
    for (const std::uint8_t grey : {kWall, kOther}) palette.colours[grey] = {230, 220, 210};
    return make_colormap(palette);
}

struct ColouredHall {
    std::string bytes = bytes_of(hall_of_lamps());
    reference::Level exact = reference::read_level({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    EffectStage stage{engine_level(bytes), camera_at(point_at(-220, 3, 90), 0, 4), even_colormap()};

    /// The mean distance of pixels from their colours in doubles.
    double error(std::int32_t levels) {
        stage.settings.accuracy.colour_levels = levels;
        stage.settings.accuracy.mip = MipSelection::None;
        const Picture picture = stage.draw();
        reference::Palette palette;
        for (std::size_t i = 0; i < 256; ++i) {
            const Rgb8& colour = stage.colormap.palette.colours[i];
            palette[i] = {colour.red + 0.0, colour.green + 0.0, colour.blue + 0.0};
        }
        double sum = 0;
        for (std::size_t i = 0; i < picture.size(); ++i) {
            const PixelRecord& pixel = stage.work.record.pixels[i];
            const reference::Rgb truth =
                true_colour(exact, exact.face(pixel.face.number()), number_of(pixel.u), number_of(pixel.v), palette);
            const reference::Rgb& shown = palette[picture[i]];
            sum += std::hypot(shown.red - truth.red, shown.green - truth.green, shown.blue - truth.blue);
        }
        return sum / static_cast<double>(picture.size());
    }
};

TEST(ColouredLight, IsNearerToTheTrueColoursWithMoreSteps) {
    ColouredHall hall;
    const double none = hall.error(0), coarse = hall.error(16), usual = hall.error(32), fine = hall.error(64);
    EXPECT_LT(usual, none * 0.7);
    EXPECT_LT(usual, coarse);
    EXPECT_LT(fine, usual);
    EXPECT_LT(fine, 0.48 * 51) << "the mean distance from a point of a cube to its nearest corner, 51 apart here";
}

TEST(ColouredLight, OfWhiteIsBuiltAsLuminanceAndCountsNothing) {
    ColouredHall hall;
    hall.stage.draw_afresh();
    hall.stage.draw();
    EXPECT_EQ(hall.stage.work.counts.stages.coloured_texels, hall.stage.work.counts.stages.lit_texels);
    EXPECT_GT(hall.stage.work.counts.stages.coloured_texels, 0);
    EffectStage white(room_with(""), camera_at(point_at(-220, 3, 90), 0));
    white.draw();
    EXPECT_GT(white.work.counts.stages.lit_texels, 0);
    EXPECT_EQ(white.work.counts.stages.coloured_texels, 0);
    EXPECT_EQ(white.work.cache.surfaces.colour_cube(), nullptr);
}

TEST(ColouredLight, IsDrawnAlikeInAWorkspaceOfOtherSettings) {
    ColouredHall hall;
    for (const std::int32_t levels : {32, 0, 16, 32}) {
        hall.stage.settings.accuracy.colour_levels = levels;
        EXPECT_EQ(hall.stage.draw(), hall.stage.draw_afresh()) << levels;
    }
}

}  // namespace
}  // namespace oblong::test

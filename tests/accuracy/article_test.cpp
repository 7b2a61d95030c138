// The article's figures on its own level: pictures are the frames', beside what is exact, and a view from a wall is
// none.

#include "tools/article/article.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "tests/support/folders.h"

namespace oblong::test {
namespace {

constexpr ArticleEye kDownTheHall{24, 60, 72, 12, 0, 0, 90};

struct ArticleLevel {
    std::vector<std::uint8_t> level = read_file(build_folder() + "/article/article.bsp"),
                              palette = read_file(source_folder() + "/assets/palette.lmp");
    Article article{level, palette};

    ArticleLevel() { EXPECT_TRUE(article.look_from(kDownTheHall)); }
};

int channel(std::uint32_t colour, int index) {
    return static_cast<int>(colour >> (8 * index) & 255);
}

/// The mean difference of all channels.
double difference(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c) sum += std::abs(channel(a[i], c) - channel(b[i], c));
    return sum / (3.0 * static_cast<double>(a.size()));
}

TEST(Article, DrawsTheFramesOfEachDial) {
    ArticleLevel shown;
    const Level level = read_bsp(shown.level);
    const Palette palette = read_palette(shown.palette);
    const Colormap colormap = make_colormap(palette);
    Camera camera;
    camera.eye = {World::from_int(24), World::from_int(60), World::from_int(72)};
    camera.yaw = degrees_to_angle(Degrees::from_int(12));
    FrameWorkspace work(level, kMeasuredMode);
    std::vector<std::uint8_t> pixels(pixel_count(kMeasuredMode.width_px, kMeasuredMode.height_px));
    Settings settings;
    settings.allowed_effects = kStillEffects;
    for (std::size_t dial = 0; dial < all_dials().size(); ++dial) {
        const std::int32_t value = all_dials()[dial].settings.front().value;
        all_dials()[dial].set(settings.accuracy, value);
        shown.article.set_dial(dial, value);
        draw_frame({level, colormap, {}}, camera, kMeasuredMode, settings, work,
                   {pixels.data(), kMeasuredMode.width_px, kMeasuredMode.height_px, kMeasuredMode.width_px});
        const std::vector<std::uint32_t>& picture = shown.article.draw();
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const Rgb8 colour = palette.colours[pixels[i]];
            const std::uint32_t wanted = 0xFF000000u | colour.blue << 16 | colour.green << 8 | colour.red;
            ASSERT_EQ(picture[i], wanted) << all_dials()[dial].name << ", pixel " << i;
        }
    }
}

TEST(Article, ExactPicturesAreNearTheReference) {
    ArticleLevel shown;
    const std::vector<std::uint32_t> exact = shown.article.draw_reference();
    const auto off_by = [&](Texturing texturing, MipSelection mip) {
        for (std::size_t dial = 0; dial < all_dials().size(); ++dial) {
            if (all_dials()[dial].name == "perspective") shown.article.set_dial(dial, static_cast<int>(texturing));
            if (all_dials()[dial].name == "mip") shown.article.set_dial(dial, static_cast<int>(mip));
        }
        return difference(shown.article.draw(), exact);
    };
    const double nearest = off_by(Texturing::Exact, MipSelection::None);
    EXPECT_LT(nearest, 8) << "the palette's distance";
    EXPECT_GT(off_by(Texturing::Affine, MipSelection::None), 1.5 * nearest);
    shown.article.draw_errors(Measure::Displacement);
    EXPECT_GT(nlohmann::json::parse(shown.article.figures()).at("rms"), 1.0) << "texels of the last, affine, frame";
}

TEST(Article, LooksFromNoWall) {
    ArticleLevel shown;
    const std::vector<std::uint32_t> before = shown.article.draw();
    EXPECT_FALSE(shown.article.look_from({-8, 60, 72, 0, 0, 0, 90}));
    EXPECT_EQ(shown.article.draw(), before);
}

}  // namespace
}  // namespace oblong::test

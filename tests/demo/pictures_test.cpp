#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <tuple>

#include "engine/base/table.h"
#include "engine/io/files.h"
#include "engine/models/obj.h"
#include "engine/pictures/picture.h"
#include "engine/surface/colormap.h"
#include "engine/surface/palette.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

const std::filesystem::path kAssets = std::filesystem::path(test::source_folder()) / "assets";

/// assets/README.md: thirteen ramps from dark to bright before all others.
constexpr std::size_t kOrdinaryRamps = 13, kRampSteps = 16;

Palette demo_palette() {
    return read_palette(read_file((kAssets / "palette.lmp").string()));
}

PngImage texture(const std::string& name) {
    return decode_png(read_file((kAssets / "textures" / (name + ".png")).string()));
}

/// Rec. 601 luma, times 1000.
int luma_1000(Rgb8 colour) {
    return 299 * colour.red + 587 * colour.green + 114 * colour.blue;
}

TEST(DemoPalette, EveryRampBrightensAtEachStepFromNearBlack) {
    const Palette palette = demo_palette();
    for (std::size_t ramp = 0; ramp < kOrdinaryRamps; ++ramp) {
        const Rgb8* steps = &palette.colours[ramp * kRampSteps];
        EXPECT_LT(luma_1000(steps[0]), 12'000) << "ramp " << ramp;
        for (std::size_t i = 1; i < kRampSteps; ++i)
            EXPECT_GT(luma_1000(steps[i]), luma_1000(steps[i - 1])) << "ramp " << ramp << " step " << i;
    }
}

TEST(DemoPalette, IndexZeroIsBlackAndNoColourComesTwice) {
    const Palette palette = demo_palette();
    EXPECT_EQ(palette.colours[0], (Rgb8{0, 0, 0}));
    std::set<std::tuple<int, int, int>> seen;
    for (const Rgb8 colour : palette.colours) seen.emplace(colour.red, colour.green, colour.blue);
    EXPECT_EQ(seen.size(), 256u);
}

TEST(DemoPalette, DarkeningABrightColourTakesManySmallSteps) {
    const Palette palette = demo_palette();
    const Colormap colormap = make_colormap(palette);
    for (std::size_t ramp = 0; ramp < kOrdinaryRamps; ++ramp) {
        const std::size_t brightest = ramp * kRampSteps + kRampSteps - 1;
        std::set<int> lumas;
        for (const auto& shade : colormap.shades) lumas.insert(luma_1000(palette.colours[shade[brightest]]));
        EXPECT_GE(lumas.size(), 14u) << "ramp " << ramp << " would show as bands";
    }
}

/// The mean luma of a texture in the light of a shade, times 1000.
double mean_luma(const std::vector<std::uint8_t>& indices, const Colormap& colormap, int shade) {
    double sum = 0;
    for (const std::uint8_t index : indices)
        sum += luma_1000(colormap.palette.colours[item(colormap.shades, shade)[index]]);
    return sum / static_cast<double>(indices.size());
}

/// A step of the mean, more than the light's own, shows as a ring around a lamp where nothing on a wall hides it.
TEST(DemoTextures, PlasterOfWallsFollowsTheLightInSmallSteps) {
    const Palette palette = demo_palette();
    const Colormap colormap = make_colormap(palette);
    for (const char* name : {"plaster_ivory", "plaster_night"}) {
        const PngImage plaster = texture(name);
        ASSERT_FALSE(plaster.indices.empty()) << name;
        ASSERT_TRUE(std::ranges::equal(plaster.colours, palette.colours, {}, &Rgba8::colour)) << name;
        double worst = 0;
        for (int shade = Colormap::kOwnShade; shade < 53; ++shade) {  // down to a third of full light
            const ShadeLight light = light_of_shade(shade), next = light_of_shade(shade + 1);
            const double step =
                mean_luma(plaster.indices, colormap, shade + 1) / mean_luma(plaster.indices, colormap, shade);
            worst = std::max(worst, std::abs(step * light.parts / next.parts - 1));
        }
        EXPECT_LT(worst, 0.09) << name;
    }
}

/// The largest difference of brightness between column x and the one left of it (the last one, for 0).
int largest_step(const PngImage& image, std::int32_t x) {
    const auto luma_at = [&](std::int32_t column, std::int32_t row) {
        return luma_1000(image.pixel(static_cast<std::size_t>(row * image.width_px + column)).colour);
    };
    int largest = 0;
    for (std::int32_t y = 0; y < image.height_px; ++y)
        largest = std::max(largest, std::abs(luma_at(x, y) - luma_at((x + image.width_px - 1) % image.width_px, y)));
    return largest;
}

TEST(DemoTextures, WhatHasNoJointsTilesWithoutASeam) {
    for (const char* name : {"marble_ivory", "#water", "earth"}) {
        const PngImage image = texture(name);
        int largest_inside = 0;
        for (std::int32_t x = 1; x < image.width_px; ++x)
            largest_inside = std::max(largest_inside, largest_step(image, x));
        EXPECT_LE(largest_step(image, 0), largest_inside) << name;
    }
}

TEST(DemoModels, EachIsReadWithoutAWarning) {
    std::size_t count = 0;
    for (const auto& file : std::filesystem::directory_iterator(kAssets / "models")) {
        if (file.path().extension() != ".obj") continue;
        const ObjModel model = read_obj(file.path().string(), demo_palette());
        EXPECT_TRUE(model.warnings.empty()) << file.path();
        EXPECT_FALSE(model.mesh.triangles.empty()) << file.path();
        ++count;
    }
    EXPECT_GE(count, 7u);
}

}  // namespace
}  // namespace oblong

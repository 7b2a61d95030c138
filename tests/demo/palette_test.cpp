#include "engine/surface/palette.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "engine/surface/colormap.h"
#include "tools/demo_level/art/ramps.h"
#include "tools/demo_level/art/textures.h"

namespace oblong {
namespace {

/// Rec. 601 luma, times 1000.
int luma_1000(Rgb8 colour) {
    return 299 * colour.red + 587 * colour.green + 114 * colour.blue;
}

TEST(DemoPalette, EveryRampBrightensAtEachStepFromNearBlack) {
    const Palette palette = art::design_palette();
    for (std::size_t ramp = 0; ramp < art::kOrdinaryRamps; ++ramp) {
        const Rgb8* steps = &palette.colours[ramp * art::kRampSteps];
        EXPECT_LT(luma_1000(steps[0]), 12'000) << "ramp " << ramp;
        for (int i = 1; i < art::kRampSteps; ++i) {
            EXPECT_GT(luma_1000(steps[i]), luma_1000(steps[i - 1])) << "ramp " << ramp << " step " << i;
        }
    }
}

TEST(DemoPalette, IndexZeroIsBlackAndNoColourComesTwice) {
    const Palette palette = art::design_palette();
    EXPECT_EQ(palette.colours[0], (Rgb8{0, 0, 0}));
    std::set<std::tuple<int, int, int>> seen;
    for (const Rgb8 colour : palette.colours) seen.emplace(colour.red, colour.green, colour.blue);
    EXPECT_EQ(seen.size(), 256u);
}

TEST(DemoPalette, DarkeningABrightColourTakesManySmallSteps) {
    const Palette palette = art::design_palette();
    const Colormap colormap = make_colormap(palette);
    for (std::size_t ramp = 0; ramp < art::kOrdinaryRamps; ++ramp) {
        const std::size_t brightest = ramp * art::kRampSteps + art::kRampSteps - 1;
        std::set<int> lumas;
        for (const auto& shade : colormap.shades) lumas.insert(luma_1000(palette.colours[shade[brightest]]));
        EXPECT_GE(lumas.size(), 14u) << "ramp " << ramp << " would show as bands";
    }
}

/// The mean luma of a texture in the light of a shade, times 1000.
double mean_luma(const std::vector<std::uint8_t>& indices, const Colormap& colormap, int shade) {
    double sum = 0;
    for (const std::uint8_t index : indices)
        sum += luma_1000(colormap.palette.colours[at(colormap.shades, shade)[index]]);
    return sum / static_cast<double>(indices.size());
}

/// A step of the mean, more than the light's own, shows as a ring around a lamp where nothing on a wall hides it.
TEST(DemoPlaster, FollowsTheLightInSmallSteps) {
    const Colormap colormap = make_colormap(art::design_palette());
    for (const art::NamedCanvas& texture : art::paint_all_textures()) {
        if (texture.name != "plaster_ivory" && texture.name != "plaster_night") continue;  // those of walls
        const std::vector<std::uint8_t> indices = texture.canvas.to_indices();
        double worst = 0;
        for (int shade = Colormap::kOwnShade; shade < 53; ++shade) {  // down to a third of full light
            const ShadeLight light = light_of_shade(shade), next = light_of_shade(shade + 1);
            const double step = mean_luma(indices, colormap, shade + 1) / mean_luma(indices, colormap, shade);
            worst = std::max(worst, std::abs(step * light.parts / next.parts - 1));
        }
        EXPECT_LT(worst, 0.09) << texture.name;
    }
}

}  // namespace
}  // namespace oblong

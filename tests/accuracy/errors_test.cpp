// Errors of the hard scenes' frames: their order along the dial of perspective, and the bound.

#include <gtest/gtest.h>

#include "tests/accuracy/scenes_fixture.h"
#include "tools/measure/texel_error.h"

namespace oblong::test {
namespace {

/// The displacements of all frames of some levels.
ErrorSummary displacement(const std::vector<MeasuredLevel>& levels, const Colormap& colormap,
                          const Accuracy& accuracy) {
    std::vector<float> all;
    for (const MeasuredLevel& level : levels) {
        LevelFrames frames(level, colormap);
        for (const Camera& camera : level.cameras) {
            TexelErrorMeter meter(level.exact, level.models, camera, kMeasuredMode);
            for (const TexelError& error : meter.measure(frames.record(camera, accuracy)))
                if (error.is_measured()) all.push_back(error.pixels);
        }
    }
    return summarize_errors(std::move(all));
}

TEST(HardScenes, MoreDivisionsAlongThePerspectiveDialMeanASmallerError) {
    const Scenes scenes(1);
    double coarser = 1e9;
    for (const Texturing texturing :
         {Texturing::Affine, Texturing::Every32, Texturing::Every16, Texturing::Every8, Texturing::Exact}) {
        const double rms = displacement(scenes.levels, scenes.colormap, textured_by(texturing)).rms;
        EXPECT_LT(rms, coarser) << static_cast<int>(texturing);
        coarser = rms;
    }
    EXPECT_LT(coarser, 0.02) << "a division a pixel is not exact";
}

TEST(HardScenes, BoundedStaysWithinItsBound) {
    const Scenes scenes(100);
    for (const MeasuredLevel& level : scenes.levels)
        for (const std::int32_t bound_256 : {32, 96, 512}) {
            Accuracy accuracy = textured_by(Texturing::Bounded);
            accuracy.pixel_bound_256 = bound_256;
            const ErrorSummary error = displacement({level}, scenes.colormap, accuracy);
            EXPECT_LE(error.max, bound_256 / 256.0) << level.name;
        }
}

/// Pixels that no face covers.
std::int64_t free_pixels(const Scenes& scenes, const Accuracy& accuracy) {
    const MeasuredLevel& level = scenes.named("slivers");
    LevelFrames frames(level, scenes.colormap);
    std::int64_t count = 0;
    for (const Camera& camera : level.cameras)
        for (const PixelRecord& pixel : frames.record(camera, accuracy).pixels) count += pixel.face.is_none();
    return count;
}

TEST(HardScenes, LooseEdgesGapeUnlessTheyAreMended) {
    const Scenes scenes(100);
    Accuracy open;
    open.mends_t_junctions = false;
    EXPECT_GT(free_pixels(scenes, open), 5);
    EXPECT_EQ(free_pixels(scenes, {}), 0);
}

}  // namespace
}  // namespace oblong::test

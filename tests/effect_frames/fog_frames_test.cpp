// Fog in whole frames: by the depth of each pixel, worked out in doubles.

#include <algorithm>
#include <cmath>

#include "tests/effect_frames/effect_stage.h"

namespace oblong::test {
namespace {

constexpr int kFogGrey = 200;  ///< 0.784 of 255
constexpr double kDensity = 0.1;
constexpr int kHalfWidth = 128, kHeight = 192, kFar = 2000;
constexpr double kEyeX = -90, kEyeY = 7, kEyeZ = 100;

/// A corridor along +x.
MapText corridor(const std::string& fog) {
    MapText text;
    text.brushes = room({-100, -kHalfWidth, 0}, {kFar, kHalfWidth, kHeight});
    if (!fog.empty()) text.world_keys = {{"fog", fog}};
    return text;
}

Camera along_corridor() {
    return camera_at(point_at(kEyeX, kEyeY, kEyeZ), 0);
}

/// How far along x the wall of a pixel is. The camera looks along x: 160 pixels across are a depth of 1, and 160 * 4/3
/// * 200/320 down.
double depth_of(std::size_t pixel) {
    const double across = (160 - (static_cast<double>(pixel % kPictureWidth) + 0.5)) / 160;
    const double up = (100 - (static_cast<double>(pixel / kPictureWidth) + 0.5)) / (160 * 4.0 / 3 * 200 / 320);
    const double to_side = across > 0 ? (kHalfWidth - kEyeY) / across : (-kHalfWidth - kEyeY) / across;
    const double to_floor = up > 0 ? (kHeight - kEyeZ) / up : -kEyeZ / up;
    return std::min({to_side, to_floor, kFar - kEyeX});
}

double expected_grey(double depth) {
    const double share = 1 - std::exp(-std::pow(kDensity / 64 * depth, 2));
    return kWall + (kFogGrey - kWall) * share;
}

TEST(FogFrames, ShareOfFogIsThatOfTheDepthAndNeverFallsWithIt) {
    EffectStage stage(corridor("0.1 0.784 0.784 0.784"), along_corridor());
    const Picture picture = stage.draw();
    EXPECT_TRUE(stage.has("fog"));
    std::vector<std::pair<double, int>> by_depth;
    constexpr double kStep = (kFogGrey - kWall) / 63.0;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const double depth = depth_of(i);
        by_depth.emplace_back(depth, picture[i]);
        ASSERT_NEAR(picture[i], expected_grey(depth), kStep / 2 + 1.1) << i << " at " << depth;
    }
    std::sort(by_depth.begin(), by_depth.end());
    int densest = 0;
    for (const auto& [depth, grey] : by_depth) {
        ASSERT_GE(grey, densest - 3) << depth;  // a level's step, where rounding decides
        densest = std::max(densest, grey);
    }
    EXPECT_GE(densest, kFogGrey - 4);
    EXPECT_LE(by_depth.front().second, kWall + 6);
}

TEST(FogFrames, NotAllowedOrAskedForThereIsNone) {
    EffectStage clear(corridor(""), along_corridor()), fog(corridor("0.1 0.784 0.784 0.784"), along_corridor());
    const Picture expected = clear.draw();
    EXPECT_FALSE(clear.has("fog"));
    EXPECT_EQ(clear.work.cache.fog_tables, nullptr);
    EXPECT_EQ(fog.draw_without(Effect::Fog), expected);
    EXPECT_FALSE(fog.has("fog"));
    EXPECT_EQ(fog.pixels(Effect::Fog), 0);
    EXPECT_EQ(fog.work.cache.fog_tables, nullptr);
    EXPECT_NE(fog.draw(), expected);
    const std::int64_t owned = fog.pixels(Effect::Fog);
    EXPECT_LE(changed_pixels(fog.draw(), expected), owned);
}

TEST(FogFrames, TheSearchForItsPixelsIsPartOfItsTime) {
    EffectStage fog(corridor("0.1 0.784 0.784 0.784"), along_corridor());
    PassTimes times{ticking_ns};
    fog.work.observers.times = &times;
    fog.draw();
    EXPECT_GT(item(times.effects_ns, Effect::Fog), 0);
    fog.draw_without(Effect::Fog);
    EXPECT_EQ(item(times.effects_ns, Effect::Fog), 0);
}

/// Above the top of low fog everything is clear for an eye above it.
TEST(FogFrames, LowFogLeavesWhatIsAboveItClear) {
    constexpr double kTop = 60;
    EffectStage fog(corridor("0.3 0.784 0.784 0.784 1 0 4096 60 30"), along_corridor());
    const Picture picture = fog.draw(), clear = fog.draw_without(Effect::Fog);
    std::int64_t low = 0;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const double up = (100 - (static_cast<double>(i / kPictureWidth) + 0.5)) / (160 * 4.0 / 3 * 200 / 320);
        const double height = kEyeZ + depth_of(i) * up;
        if (height > kTop + 1) {
            ASSERT_EQ(picture[i], clear[i]) << height;
        }
        low += picture[i] != clear[i];
    }
    EXPECT_GT(low, 5'000);
}

}  // namespace
}  // namespace oblong::test

// However many threads draw a frame, it has the same bytes.

#include "engine/frame/shared_drawing.h"

#include <gtest/gtest.h>

#include "engine/platform/worker_threads.h"
#include "engine/view/views.h"
#include "tests/frame/frame_fixture.h"
#include "tests/support/pictures.h"

namespace oblong::test {
namespace {

/// Draws with 2, 3 and 8 threads what one draws.
void expect_same_bytes(Stage& stage, std::size_t camera_count) {
    const std::vector<Camera> cameras = cameras_at_entities(stage.level, camera_count);
    ASSERT_FALSE(cameras.empty());
    FrameWorkspace alone(stage.level, stage.mode);
    std::vector<std::vector<std::uint8_t>> pictures;
    for (const Camera& camera : cameras) {
        stage.draw(camera, alone);
        pictures.push_back(stage.pixels);
    }
    for (const int threads : {2, 3, 8}) {
        WorkerThreads workers(threads);
        FrameWorkspace shared(stage.level, stage.mode, &workers);
        ASSERT_TRUE(shared.shared);
        for (std::size_t i = 0; i < cameras.size(); ++i) {
            std::fill(stage.pixels.begin(), stage.pixels.end(), std::uint8_t{0x5a});
            stage.draw(cameras[i], shared);
            EXPECT_FALSE(shared.shared->is_on());
            ASSERT_EQ(stage.pixels, pictures[i]) << threads << " threads, camera " << i;
        }
    }
}

TEST(SharedDrawing, OfOneThreadIsNone) {
    const Stage stage = demo_stage();
    WorkerThreads alone(1);
    EXPECT_FALSE(FrameWorkspace(stage.level, stage.mode, &alone).shared);
    EXPECT_FALSE(FrameWorkspace(stage.level, stage.mode).shared);
}

TEST(SharedDrawing, OfTheDemoLevelHasTheSameBytesInEveryPreset) {
    Stage stage = demo_stage();
    for (const Preset preset : kPresets) {
        stage.settings.accuracy = accuracy_of(preset);
        expect_same_bytes(stage, 12);
    }
}

TEST(SharedDrawing, OfRealLevelsHasTheSameBytes) {
    OBLONG_NEEDS_SHARED_LEVELS();
    for (const char* name : kRealLevels) {
        Stage stage = real_stage(name);
        expect_same_bytes(stage, 20);
        stage.settings.accuracy.mip = MipSelection::Span;
        expect_same_bytes(stage, 6);
    }
}

TEST(SharedDrawing, OfALargeModeHasTheSameBytes) {
    Stage stage = demo_stage({1600, 1200});
    expect_same_bytes(stage, 6);
}

/// From above, a level shows more faces than wait at once.
TEST(SharedDrawing, OfManyFacesHasTheSameBytes) {
    Stage stage = demo_stage({640, 480});
    const ScreenMode& mode = stage.mode;
    stage.settings.accuracy.mip = MipSelection::Span;
    WorkerThreads workers(3);
    FrameWorkspace alone(stage.level, mode), shared(stage.level, mode, &workers);
    const ViewSpec view = orthographic_view(cameras_at_entities(stage.level, 1).front().eye, side_axes(ViewSide::Top),
                                            View::from_int(4096));
    const auto drawn = [&](FrameWorkspace& work) {
        std::fill(stage.pixels.begin(), stage.pixels.end(), std::uint8_t{0x5a});
        draw_frame(stage.scene(), view, mode, stage.settings, work,
                   {stage.pixels.data(), mode.width_px, mode.height_px, mode.width_px});
        return stage.pixels;
    };
    EXPECT_TRUE(same_picture(drawn(shared), drawn(alone)));
    EXPECT_GT(shared.view.claims.list(FaceList::Walls).size(), 512u);
}

/// Two workers that draw after each other, at the end, the second one first.
class LateWorkers final : public Workers {
  public:
    int count() const override { return 2; }
    void begin(SharedWork& work) override { work_ = &work; }
    void end() override {
        while (work_->do_part(1 - static_cast<int>(parts % 2))) ++parts;
    }

    std::int64_t parts = 0;

  private:
    SharedWork* work_ = nullptr;
};

/// However late the parts are drawn, no pixel is left out.
TEST(SharedDrawing, AtTheEndHasTheSameBytes) {
    for (const ScreenMode mode : {ScreenMode{320, 200}, ScreenMode{1280, 800}, ScreenMode{333, 77}}) {
        Stage stage = demo_stage(mode);
        LateWorkers late;
        FrameWorkspace alone(stage.level, stage.mode), shared(stage.level, stage.mode, &late);
        for (const Camera& camera : cameras_at_entities(stage.level, 20)) {
            std::fill(stage.pixels.begin(), stage.pixels.end(), std::uint8_t{0x5a});
            stage.draw(camera, shared);
            const std::vector<std::uint8_t> pixels = stage.pixels;
            stage.draw(camera, alone);
            ASSERT_TRUE(same_picture(pixels, stage.pixels));
        }
        EXPECT_GT(late.parts, 20);
    }
}

}  // namespace
}  // namespace oblong::test

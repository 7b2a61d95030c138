// However many threads draw a frame, it has the same bytes.

#include "engine/frame/shared_drawing.h"

#include <gtest/gtest.h>

#include "engine/platform/worker_threads.h"
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

/// In so large a mode a frame has more spans than wait at once, and a face's spans are several items.
TEST(SharedDrawing, OfALargeModeHasTheSameBytes) {
    Stage stage = demo_stage({1600, 1200});
    expect_same_bytes(stage, 6);
}

/// Does items only when it is asked to, in whatever order: the last ones first.
class LateWorker final : public Workers {
  public:
    int count() const override { return 2; }
    void begin(SharedWork& work) override {
        work_ = &work;
        added_ = 0;
        finished_ = 0;
    }
    void add_item() override { ++added_; }
    void finish_items() override {
        for (std::uint32_t item = added_; item-- > finished_;) work_->do_item(item, static_cast<int>(item % 2));
        finished_ = added_;
    }
    void end() override { all_items += added_; }

    std::int64_t all_items = 0;

  private:
    SharedWork* work_ = nullptr;
    std::uint32_t added_ = 0, finished_ = 0;
};

/// Each span is in one item: drawn in the opposite order, the picture is the same, and no pixel is left out.
TEST(SharedDrawing, InTheOppositeOrderHasTheSameBytes) {
    for (const ScreenMode mode : {ScreenMode{320, 200}, ScreenMode{1280, 800}}) {
        Stage stage = demo_stage(mode);
        LateWorker late;
        FrameWorkspace alone(stage.level, stage.mode), shared(stage.level, stage.mode, &late);
        for (const Camera& camera : cameras_at_entities(stage.level, 20)) {
            std::fill(stage.pixels.begin(), stage.pixels.end(), std::uint8_t{0x5a});
            stage.draw(camera, shared);
            const std::vector<std::uint8_t> pixels = stage.pixels;
            stage.draw(camera, alone);
            ASSERT_TRUE(same_picture(pixels, stage.pixels));
        }
        EXPECT_GT(late.all_items, 20);
    }
}

}  // namespace
}  // namespace oblong::test

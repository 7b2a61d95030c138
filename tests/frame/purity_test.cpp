#include <gtest/gtest.h>

#include <algorithm>

#include "engine/frame/observers.h"
#include "engine/level/level.h"
#include "engine/visibility/eye.h"
#include "tests/frame/frame_fixture.h"
#include "tests/support/pictures.h"

namespace oblong::test {
namespace {

// A frame is a pure function of scene, camera, mode and settings: what was drawn before, what is kept, and who counts
// along make no difference.

std::vector<std::uint8_t> drawn_afresh(Stage& stage, const Camera& camera) {
    ObservedWorkspace work(stage.level, stage.mode);
    stage.draw(camera, work);
    return stage.pixels;
}

bool is_named(const Level& level, const Face& face, const char* start) {
    return level.texture_of(face).name.starts_with(start);
}

constexpr std::int64_t kReading_ns = 30;
std::int64_t now_ns = 0, readings = 0;

std::int64_t slow_clock_ns() {
    ++readings;
    return now_ns += kReading_ns;
}

// The walk and faces of models alternate. Both sums are right, although the clock is read for only one in 17, and do
// not include the time to read it.
TEST(Observers, SamplesStandForAllOfTheirKind) {
    PassTimes times{slow_clock_ns};
    now_ns = readings = 0;
    for (int i = 0; i < 1700; ++i) {
        {
            const SampledStopwatch watch(&times, &PassTimes::walk_ns);
            now_ns += 100;
        }
        const SampledStopwatch watch(&times, Effect::BrushModels);
        now_ns += 700;
    }
    EXPECT_EQ(times.walk_ns, 1700 * 100);
    EXPECT_EQ(item(times.effects_ns, Effect::BrushModels), 1700 * 700);
    EXPECT_EQ(readings, 3 * 2 * 1700 / 17);
}

TEST(Observers, WithoutTimesNothingIsRead) {
    readings = 0;
    { const SampledStopwatch watch(nullptr, Effect::BrushModels); }
    EXPECT_EQ(readings, 0);
}

}  // namespace

/// What kernels were given to draw, in order: a kernel is a plain function, so this can't be handed to it.
struct DrawnBlocks {
    std::uint64_t hash = 14695981039346656037u;
    std::int64_t blocks = 0, pixels = 0;
    std::int64_t held = 0, beyond = 0;  ///< on surfaces that hold their blocks, and of these those that leave them
    bool operator==(const DrawnBlocks&) const = default;

    void note(std::uint64_t value) { hash = (hash ^ value) * 1099511628211u; }
} drawn_blocks;

/// Whether both ends of a block, and so all between, are texels of the surface.
bool stays_within(const TexelBlock& block, const SurfaceView& surface) {
    const auto is_within = [&](std::int64_t from_16, std::int64_t step_16, std::int32_t size) {
        const std::int64_t to_16 = from_16 + step_16 * (block.count - 1);
        return from_16 >> 16 < size && to_16 >= 0 && to_16 >> 16 < size;
    };
    return is_within(block.u_16, block.u_step_16, surface.width) &&
           is_within(block.v_16, block.v_step_16, surface.height);
}

void draw_and_note(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    for (const TexelBlock& block : blocks) {
        for (const std::uint32_t value : {block.pixel, static_cast<std::uint32_t>(block.count), block.u_16, block.v_16})
            drawn_blocks.note(value);
        ++drawn_blocks.blocks;
        drawn_blocks.pixels += block.count;
        drawn_blocks.held += surface.holds_blocks;
        drawn_blocks.beyond += surface.holds_blocks && !stays_within(block, surface);
    }
    draw_blocks_plain(blocks, surface, pixels);
}

bool divides_no_pixel(const Accuracy& accuracy) {
    return accuracy.texturing != Texturing::Bounded && accuracy.texturing != Texturing::Exact;
}

std::int64_t any_time_ns() {
    return 0;
}

// Counts, records and times are of what is drawn when nobody looks, not of another way to the same bytes: the same
// blocks come to the kernels, and the blocks that are counted are those.
TEST(Purity, WhatIsWatchedTakesThePathThatIsDrawn) {
    Stage stage = demo_stage();
    stage.settings.allowed_effects = {};  // which have kernels of their own
    ObservedWorkspace work(stage.level, stage.mode);
    Kernels noting = best_kernels();
    noting.draw_blocks = draw_and_note;
    stage.settings.kernels = &noting;
    std::int64_t held = 0;
    for (const Preset preset : kPresets) {
        stage.settings.accuracy = accuracy_of(preset);
        for (const Camera& camera : cameras_at_entities(stage.level, 40)) {
            SCOPED_TRACE(name_of(preset));
            const auto drawn = [&] {
                drawn_blocks = {};
                stage.draw(camera, work);
                return drawn_blocks;
            };
            drawn();  // lights surfaces
            const DrawnBlocks unwatched = drawn();
            held += unwatched.held;
            EXPECT_EQ(unwatched.beyond, 0);
            work.count();
            EXPECT_EQ(drawn(), unwatched) << "counted";
            if (divides_no_pixel(stage.settings.accuracy)) {
                EXPECT_EQ(work.counts.stages.blocks, unwatched.blocks);
            }
            work.observers.counts = nullptr;
            work.keep_record();
            EXPECT_EQ(drawn(), unwatched) << "recorded";
            work.observers.record = nullptr;
            PassTimes times{any_time_ns};
            work.observers.times = &times;
            EXPECT_EQ(drawn(), unwatched) << "timed";
            work.observers.times = nullptr;
        }
    }
    EXPECT_GT(held, 0);
}

TEST(Purity, AModelThatMovedIsDrawnWhereItIs) {
    Stage stage = demo_stage();
    ASSERT_FALSE(stage.models.empty());
    ObservedWorkspace used(stage.level, stage.mode);
    bool any_differs = false;
    for (const Camera& camera : cameras_at_entities(stage.level, 40)) {
        for (PlacedModel& model : stage.models) model.offset = {};
        stage.draw(camera, used);
        const std::vector<std::uint8_t> at_rest = stage.pixels;
        for (PlacedModel& model : stage.models) model.offset.z = World::from_int(24);
        stage.draw(camera, used);
        const std::vector<std::uint8_t> moved = stage.pixels;
        EXPECT_TRUE(same_picture(drawn_afresh(stage, camera), moved));
        any_differs |= moved != at_rest;
    }
    EXPECT_TRUE(any_differs) << "no camera saw a model move";
}

TEST(Plan, WhatIsLeftOutIsOneColourAndStillClosesTheWorld) {
    Stage stage = demo_stage();
    ObservedWorkspace work(stage.level, stage.mode);
    std::size_t changed = 0;
    for (const Camera& camera : cameras_at_entities(stage.level, 40)) {
        stage.settings.allowed_effects = EffectSet::all();
        stage.draw(camera, work);
        const std::vector<std::uint8_t> with_all = stage.pixels;
        stage.settings.allowed_effects = {};
        work.count();
        stage.draw(camera, work);
        EXPECT_EQ(std::count(work.counts.writes.begin(), work.counts.writes.end(), 1), 320 * 200);
        work.observers.counts = nullptr;
        changed += stage.pixels != with_all;
    }
    EXPECT_GT(changed, 0u);
}

TEST(Eye, HardCaseV11_InThePlaneOfAFaceIsAStepToTheBackOfIt) {
    OBLONG_NEEDS_SHARED_LEVELS();
    Stage stage = real_stage("e1m7");
    const Camera in_plane{point_at(-224, 376, 192), {}, {}, {}};  // a light in the plane of its ceiling
    Camera below = in_plane;
    below.eye.z.raw -= 2;
    EXPECT_TRUE(same_picture(drawn_afresh(stage, in_plane), drawn_afresh(stage, below)));
}

/// Places in the middle of the level's level surfaces of water, slime and lava, exactly as high as those.
std::vector<Vec3<World>> middles_of_liquids(const Level& level) {
    std::vector<Vec3<World>> middles;
    for (const Face& face : level.faces) {
        const LevelPlane& plane = level.planes[face.plane];
        if (!is_named(level, face, "*") || plane.normal.z != Unit::from_int(1)) continue;
        std::int64_t x = 0, y = 0;
        Vec3<World> corner;
        for (const SurfEdge edge : level.edges_of(face)) {
            corner = level.vertices[level.start_of(edge)];
            x += corner.x.raw;
            y += corner.y.raw;
        }
        const auto mean = [&](std::int64_t sum) {
            return World::from_raw(static_cast<std::int32_t>(sum / face.edges.count));
        };
        middles.push_back({mean(x), mean(y), corner.z});
    }
    return middles;
}

TEST(Eye, HardCaseV11_InASurfaceOfWaterIsAStepBelowIt) {
    std::vector<Stage> stages;
    stages.push_back(demo_stage());
    if (!find_shared_folder().empty())
        for (const char* name : kRealLevels) stages.push_back(real_stage(name));
    int compared = 0;
    for (Stage& stage : stages) {
        const std::vector<Vec3<World>> middles = middles_of_liquids(stage.level);
        const std::size_t stride = middles.size() / 12 + 1;
        for (std::size_t i = 0; i < middles.size(); i += stride) {
            Camera in_surface;
            in_surface.eye = middles[i];
            in_surface.yaw = Angle::from_bam(static_cast<std::int64_t>(i) * 9973);
            Camera below = in_surface;
            below.eye.z.raw -= 2;
            if (stage.level.leaves[place_eye(stage.level, below.eye).leaf].contents == contents::kSolid) continue;
            ObservedWorkspace work(stage.level, stage.mode);
            work.count();
            stage.draw(in_surface, work);
            EXPECT_EQ(std::count(work.counts.writes.begin(), work.counts.writes.end(), 1), 320 * 200) << i;
            const std::vector<std::uint8_t> pixels = stage.pixels;
            EXPECT_TRUE(same_picture(pixels, drawn_afresh(stage, below))) << i;
            ++compared;
        }
    }
    EXPECT_GT(compared, 0);
}

TEST(Eye, ClearOfAllPlanesStaysWhereItIs) {
    Stage stage = demo_stage();
    for (const Camera& camera : cameras_at_entities(stage.level, 40)) {
        const PlacedEye placed = place_eye(stage.level, camera.eye);
        const Vec3<World> moved = placed.position - camera.eye;
        for (const World part : {moved.x, moved.y, moved.z}) EXPECT_LE(std::abs(part.raw), 8);
        EXPECT_EQ(placed.leaf, find_leaf(stage.level, stage.level.world(), placed.position));
    }
}
}  // namespace oblong::test

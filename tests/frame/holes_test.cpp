// A world drawn front to back into free intervals has a hole wherever a pixel is never written, and a mistake in its
// bookkeeping wherever one is written twice. Neither may happen from any point that is not solid.

#include <gtest/gtest.h>

#include <random>

#include "engine/level/entities.h"
#include "engine/level/side.h"
#include "tests/frame/frame_fixture.h"

namespace oblong::test {

namespace {

/// Neither in a wall nor behind the sky.
bool is_open(const Level& level, const Vec3<World>& p) {
    const Leaf& leaf = level.leaves[static_cast<std::size_t>(find_leaf(level, level.models[0], p))];
    return leaf.contents != contents::kSolid && leaf.contents != contents::kSky;
}

std::vector<Vec3<World>> entity_origins(const Level& level) {
    std::vector<Vec3<World>> points;
    for (const Entity& entity : level.entities) {
        const std::optional<Vec3<World>> p = parse_world_vector(entity.value("origin"));
        if (p && is_open(level, *p)) points.push_back(*p);
    }
    return points;
}

Vec3<World> box_point(const LevelBox& box, const std::array<std::int32_t, 3>& parts_of_16) {
    const auto at = [&](std::size_t axis) {
        const std::int64_t low = std::int64_t{box.mins[axis]} * 4096, high = std::int64_t{box.maxs[axis]} * 4096;
        return World::from_raw(static_cast<std::int32_t>(low + (high - low) * parts_of_16[axis] / 16));
    };
    return {at(0), at(1), at(2)};
}

std::vector<Vec3<World>> leaf_centres(const Level& level) {
    std::vector<Vec3<World>> points;
    for (std::int32_t leaf = 1; leaf <= level.models[0].visible_leaf_count; ++leaf) {
        const Vec3<World> p = box_point(level.leaves[static_cast<std::size_t>(leaf)].box, {8, 8, 8});
        if (is_open(level, p)) points.push_back(p);
    }
    return points;
}

/// Where and how a picture was wrong, in words a camera file takes.
std::string describe(const Camera& camera, std::int64_t never, std::int64_t twice) {
    const auto units = [](World w) { return std::to_string(static_cast<double>(w.raw) / 4096); };
    const auto degrees = [](Angle a) { return std::to_string(a.bam * 360.0 / 65536); };
    return units(camera.eye.x) + "," + units(camera.eye.y) + "," + units(camera.eye.z) + "," + degrees(camera.yaw) +
           "," + degrees(camera.pitch) + "," + degrees(camera.roll) + ": never " + std::to_string(never) + ", twice " +
           std::to_string(twice);
}

std::string first_wrong_pixels(const Stage& stage, const FrameCounts& counts) {
    std::string text = " at";
    int shown = 0;
    for (std::size_t i = 0; i < counts.writes.size() && shown < 8; ++i) {
        if (counts.writes[i] == 1) continue;
        const auto width = static_cast<std::size_t>(stage.mode.width_px);
        text += " (" + std::to_string(i % width) + "," + std::to_string(i / width) + ")";
        ++shown;
    }
    return text;
}

void expect_each_pixel_once(Stage& stage, const Camera& camera, FrameWorkspace& work) {
    stage.draw(camera, work);
    std::int64_t never = 0, twice = 0;
    for (const std::uint8_t writes : work.counts->writes) {
        never += writes == 0;
        twice += writes > 1;
    }
    if (never != 0 || twice != 0)
        ADD_FAILURE() << describe(camera, never, twice) << first_wrong_pixels(stage, *work.counts);
}

/// 8 yaws, 3 pitches from each point.
void expect_no_holes_around(Stage& stage, const std::vector<Vec3<World>>& points, std::size_t every) {
    FrameWorkspace work(stage.level, stage.mode);
    work.counts = std::make_unique<FrameCounts>();
    for (std::size_t i = 0; i < points.size() && !testing::Test::HasFailure(); i += every)
        for (int yaw = 0; yaw < 8; ++yaw)
            for (const int pitch : {-30, 0, 30}) {
                Camera camera;
                camera.eye = points[i];
                camera.yaw = Angle::from_bam(yaw * 8192);
                camera.pitch = Angle::from_bam(pitch * 65536 / 360);
                expect_each_pixel_once(stage, camera, work);
            }
}

class RealHoles : public testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(RealHoles, NoneFromEntities) {
    OBLONG_NEEDS_SHARED_LEVELS();
    Stage stage = real_stage(GetParam());
    const auto points = entity_origins(stage.level);
    ASSERT_GT(points.size(), 50u);
    expect_no_holes_around(stage, points, 1);
}

/// The 1991 tier moves corners by up to half a pixel. Faces that share an edge move with it, but what hides the edge of
/// something far behind it moves by itself, and where both lie in a plane through the eye a pixel between them can stay
/// free. How rare that is, is the claim: a pixel in 30 million at most.
TEST_P(RealHoles, HardlyAnyWithVerticesOnWholePixels) {
    OBLONG_NEEDS_SHARED_LEVELS();
    Stage stage = real_stage(GetParam());
    stage.settings.accuracy = accuracy_of(Tier::Year1991);
    FrameWorkspace work(stage.level, stage.mode);
    work.counts = std::make_unique<FrameCounts>();
    std::int64_t never = 0, pixels = 0;
    for (const Vec3<World>& point : entity_origins(stage.level))
        for (int yaw = 0; yaw < 8; ++yaw) {
            Camera camera;
            camera.eye = point;
            camera.yaw = Angle::from_bam(yaw * 8192);
            camera.pitch = Angle::from_bam(yaw * 1000 - 4000);
            stage.draw(camera, work);
            never += std::count(work.counts->writes.begin(), work.counts->writes.end(), 0);
            pixels += static_cast<std::int64_t>(work.counts->writes.size());
        }
    RecordProperty("never", std::to_string(never));
    EXPECT_LE(never, pixels / 30'000'000) << never << " of " << pixels;
}

TEST_P(RealHoles, NoneFromLeafCentres) {
    OBLONG_NEEDS_SHARED_LEVELS();
    Stage stage = real_stage(GetParam());
    const auto points = leaf_centres(stage.level);
    ASSERT_GT(points.size(), 200u);
    expect_no_holes_around(stage, points, 3);
}

TEST_P(RealHoles, HardCaseV12_NoneFromCornersOfLeaves) {
    OBLONG_NEEDS_SHARED_LEVELS();
    Stage stage = real_stage(GetParam());
    FrameWorkspace work(stage.level, stage.mode);
    work.counts = std::make_unique<FrameCounts>();
    std::mt19937 random(12);
    for (int found = 0; found < 1500 && !HasFailure();) {
        // A corner of a leaf's box, or a step of World to a unit away from it: as near to walls as an eye can be.
        const auto leaf = 1 + random() % static_cast<std::uint32_t>(stage.level.models[0].visible_leaf_count);
        const auto corner = [&] { return random() % 2 ? 0 : 16; };
        Vec3<World> p = box_point(stage.level.leaves[leaf].box, {corner(), corner(), corner()});
        const auto away = [&] { return World::from_raw(static_cast<std::int32_t>(random() % 3) - 1); };
        const std::int32_t scale = 1 << random() % 13;
        p.x.raw += away().raw * scale;
        p.y.raw += away().raw * scale;
        p.z.raw += away().raw * scale;
        if (!is_open(stage.level, p)) continue;
        ++found;
        Camera camera;
        camera.eye = p;
        camera.yaw = Angle::from_bam(random());
        camera.pitch = Angle::from_bam(random() % 32768 - 16384);
        camera.roll = random() % 4 ? Angle{} : Angle::from_bam(random());
        camera.field_of_view = Degrees::from_int(random() % 4 ? 90 : 30 + random() % 120);
        expect_each_pixel_once(stage, camera, work);
    }
}

TEST_P(RealHoles, NoneInAnyModeOrTier) {
    OBLONG_NEEDS_SHARED_LEVELS();
    for (const ScreenMode mode :
         {ScreenMode{640, 400, {4, 3}}, ScreenMode{1280, 800, {16, 10}}, ScreenMode{61, 47, {4, 3}}})
        for (const Tier tier : {Tier::Year1991, Tier::Year1994, Tier::Year1996, Tier::Bounded, Tier::Exact}) {
            SCOPED_TRACE(std::to_string(mode.width_px) + " wide, " + std::string(name_of(tier)));
            Stage stage = real_stage(GetParam(), mode);
            stage.settings.accuracy = accuracy_of(tier);
            expect_no_holes_around(stage, entity_origins(stage.level), 40);
        }
}

INSTANTIATE_TEST_SUITE_P(Levels, RealHoles, testing::ValuesIn(kRealLevels),
                         [](const auto& name) { return name.param; });

TEST(DemoHoles, NoneFromEntities) {
    Stage stage = demo_stage();
    expect_no_holes_around(stage, entity_origins(stage.level), 1);
}

TEST(DemoHoles, NoneFromLeafCentres) {
    Stage stage = demo_stage();
    const auto points = leaf_centres(stage.level);
    ASSERT_GT(points.size(), 100u);
    expect_no_holes_around(stage, points, 5);
}

}  // namespace oblong::test

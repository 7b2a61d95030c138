// A world drawn front to back into free intervals has a hole wherever a pixel is never written, and a mistake in its
// bookkeeping wherever one is written twice. Neither may happen from any point that is not solid.

#include "tests/frame/holes.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/level/entities.h"

namespace oblong::test {

namespace {

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
    for (const LeafIndex leaf : level.visible_leaves()) {
        const Vec3<World> p = box_point(level.leaves[leaf].box, {8, 8, 8});
        if (is_open(level, p)) points.push_back(p);
    }
    return points;
}

/// 8 yaws, 3 pitches from each point.
void expect_no_holes_around(Stage& stage, const std::vector<Vec3<World>>& points, std::size_t every) {
    const auto work = counting_workspace(stage);
    for (std::size_t i = 0; i < points.size() && !testing::Test::HasFailure(); i += every)
        for (int yaw = 0; yaw < 8; ++yaw)
            for (const int pitch : {-30, 0, 30}) {
                Camera camera;
                camera.eye = points[i];
                camera.yaw = Angle::from_bam(yaw * 8192);
                camera.pitch = Angle::from_bam(pitch * 65536 / 360);
                expect_each_pixel_once(stage, camera, *work);
            }
}

LeafIndex random_leaf(const Level& level, std::mt19937& random) {
    return LeafIndex(
        static_cast<std::int32_t>(1 + random() % static_cast<std::uint32_t>(level.world().visible_leaf_count)));
}

/// Anywhere in the box of a leaf, looking anywhere.
Camera random_camera(const Level& level, std::mt19937& random) {
    const LeafIndex leaf = random_leaf(level, random);
    const auto part = [&] { return static_cast<std::int32_t>(random() % 17); };
    Camera camera;
    camera.eye = box_point(level.leaves[leaf].box, {part(), part(), part()});
    camera.yaw = Angle::from_bam(random());
    camera.pitch = Angle::from_bam(random() % 32768 - 16384);
    camera.roll = random() % 4 ? Angle{} : Angle::from_bam(random());
    return camera;
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

/// Corners move by up to half a pixel in the 1991 preset: faces turn round, and what no visible set holds comes into
/// sight.
TEST_P(RealHoles, NoneWithVerticesOnWholePixels) {
    OBLONG_NEEDS_SHARED_LEVELS();
    Stage stage = real_stage(GetParam());
    stage.settings.accuracy = accuracy_of(Preset::Year1991);
    const auto work = counting_workspace(stage);
    std::mt19937 random(91);
    for (int found = 0; found < 3000 && !HasFailure();) {
        // On whole units, as corners are: there edges of faces far apart line up.
        Camera camera = random_camera(stage.level, random);
        for (World* const coordinate : {&camera.eye.x, &camera.eye.y, &camera.eye.z}) coordinate->raw &= ~4095;
        if (!is_open(stage.level, camera.eye)) continue;
        ++found;
        expect_each_pixel_once(stage, camera, *work);
    }
}

/// Three frames of the 1991 preset that had 10, 3 and 7 pixels free: what shows there is in no visible set of the
/// eye's.
TEST(WholePixelHoles, NoneWhereEdgesFarApartLineUp) {
    OBLONG_NEEDS_SHARED_LEVELS();
    struct Case {
        const char* level;
        std::array<std::int32_t, 3> eye;
        std::array<std::int32_t, 3> angles;
    };
    for (const Case& known :
         {Case{"e1m7", {335, -332, 192}, {58890, 2939, 23855}}, Case{"end", {-962, 3068, 243}, {34937, 615, 9235}},
          Case{"dm4", {428, -544, 52}, {39698, 63553, 0}}}) {
        Stage stage = real_stage(known.level);
        stage.settings.accuracy = accuracy_of(Preset::Year1991);
        Camera camera;
        camera.eye = {World::from_int(known.eye[0]), World::from_int(known.eye[1]), World::from_int(known.eye[2])};
        camera.yaw = Angle::from_bam(known.angles[0]);
        camera.pitch = Angle::from_bam(known.angles[1]);
        camera.roll = Angle::from_bam(known.angles[2]);
        expect_each_pixel_once(stage, camera, *counting_workspace(stage));
    }
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
    const auto work = counting_workspace(stage);
    std::mt19937 random(12);
    for (int found = 0; found < 1500 && !HasFailure();) {
        // A corner of a leaf's box, or a step of World to a unit away from it: as near to walls as an eye can be.
        const LeafIndex leaf = random_leaf(stage.level, random);
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
        expect_each_pixel_once(stage, camera, *work);
    }
}

TEST_P(RealHoles, NoneInAnyModeOrTier) {
    OBLONG_NEEDS_SHARED_LEVELS();
    for (const ScreenMode mode : {ScreenMode{640, 400, {4, 3}}, ScreenMode{1280, 800, {16, 10}},
                                  ScreenMode{4096, 200, {4, 3}}, ScreenMode{61, 47, {4, 3}}})
        for (const Preset preset :
             {Preset::Year1991, Preset::Year1994, Preset::Year1996, Preset::Bounded, Preset::Exact}) {
            SCOPED_TRACE(std::to_string(mode.width_px) + " wide, " + std::string(name_of(preset)));
            Stage stage = real_stage(GetParam(), mode);
            stage.settings.accuracy = accuracy_of(preset);
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

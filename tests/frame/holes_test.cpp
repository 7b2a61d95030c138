// A world drawn front to back into free intervals has a hole wherever a pixel is never written, and a mistake in its
// bookkeeping wherever one is written twice. Neither may happen from any point that is not solid.

#include "tests/frame/holes.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/random.h"
#include "tests/support/views.h"

namespace oblong::test {

namespace {

Vec3<World> box_point(const LevelBox& box, const std::array<std::int32_t, 3>& parts_of_16) {
    const auto at = [&](std::size_t axis) {
        const std::int64_t low = std::int64_t{box.mins[axis]} * 4096, high = std::int64_t{box.maxs[axis]} * 4096;
        return World::from_raw(static_cast<std::int32_t>(low + (high - low) * parts_of_16[axis] / 16));
    };
    return {at(0), at(1), at(2)};
}

/// From each point `yaws` directions and 3 pitches: 8, or 4, which see all around, too, and are other ones at every
/// second point.
void expect_no_holes_around(Stage& stage, const std::vector<Vec3<World>>& points, std::size_t every, int yaws = 8) {
    const auto work = counting_workspace(stage);
    for (std::size_t i = 0; i < points.size() && !testing::Test::HasFailure(); i += every) {
        const int first = yaws == 4 && i / every % 2 != 0 ? 45 : 0;
        for (int yaw = 0; yaw < yaws; ++yaw)
            for (const int pitch : {-30, 0, 30})
                expect_each_pixel_once(stage, camera_at(points[i], first + yaw * 360 / yaws, pitch), *work);
    }
}

LeafIndex random_leaf(const Level& level, std::mt19937& random) {
    return LeafIndex(
        static_cast<std::int32_t>(1 + random() % static_cast<std::uint32_t>(level.world().visible_leaf_count)));
}

Camera random_look_from(const Vec3<World>& eye, std::mt19937& random) {
    const Angle pitch = Angle::from_bam(random_below(random, 32768) - 16384);
    return {eye, random_angle(random), pitch, random() % 4 ? Angle{} : random_angle(random)};
}

/// Anywhere in the box of a leaf, looking anywhere.
Camera random_camera(const Level& level, std::mt19937& random) {
    const LeafIndex leaf = random_leaf(level, random);
    const auto part = [&] { return random_below(random, 17); };
    return random_look_from(box_point(level.leaves[leaf].box, {part(), part(), part()}), random);
}

class Holes : public OfLevel {};
class RealHoles : public OfLevel {};

}  // namespace

TEST_P(Holes, NoneFromEntities) {
    Stage stage = stage_named(GetParam());
    const auto points = open_origins(stage.level);
    ASSERT_GT(points.size(), 20u);
    expect_no_holes_around(stage, points, 1);
}

OBLONG_FOR_ALL_LEVELS(Holes);

/// Corners move by up to half a pixel in the 1991 preset: faces turn round, and what no visible set holds comes into
/// sight.
TEST_P(RealHoles, NoneWithVerticesOnWholePixels) {
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
        Camera camera;
    };
    for (const Case& known : {Case{"e1m7", {point_at(335, -332, 192), Angle{58890}, Angle{2939}, Angle{23855}}},
                              Case{"end", {point_at(-962, 3068, 243), Angle{34937}, Angle{615}, Angle{9235}}},
                              Case{"dm4", {point_at(428, -544, 52), Angle{39698}, Angle{63553}, Angle{}}}}) {
        Stage stage = real_stage(known.level);
        stage.settings.accuracy = accuracy_of(Preset::Year1991);
        expect_each_pixel_once(stage, known.camera, *counting_workspace(stage));
    }
}

TEST_P(RealHoles, HardCaseV12_NoneFromCornersOfLeaves) {
    Stage stage = real_stage(GetParam());
    const auto work = counting_workspace(stage);
    std::mt19937 random(12);
    for (int found = 0; found < 1500 && !HasFailure();) {
        // A corner of a leaf's box, or a step of World to a unit away from it: as near to walls as an eye can be.
        const LeafIndex leaf = random_leaf(stage.level, random);
        const auto corner = [&] { return random() % 2 ? 0 : 16; };
        Vec3<World> p = box_point(stage.level.leaves[leaf].box, {corner(), corner(), corner()});
        const std::int32_t scale = 1 << random() % 13;
        for (World* part : {&p.x, &p.y, &p.z}) part->raw += (random_below(random, 3) - 1) * scale;
        if (!is_open(stage.level, p)) continue;
        ++found;
        Camera camera = random_look_from(p, random);
        camera.field_of_view = Degrees::from_int(random() % 4 ? 90 : 30 + random() % 120);
        expect_each_pixel_once(stage, camera, *work);
    }
}

TEST_P(RealHoles, NoneInAnyModeOrTier) {
    for (const ScreenMode mode : {ScreenMode{640, 400, {4, 3}}, ScreenMode{1280, 800, {16, 10}},
                                  ScreenMode{4096, 200, {4, 3}}, ScreenMode{61, 47, {4, 3}}})
        for (const Preset preset : kPresets) {
            SCOPED_TRACE(std::to_string(mode.width_px) + " wide, " + std::string(name_of(preset)));
            Stage stage = real_stage(GetParam(), mode);
            stage.settings.accuracy = accuracy_of(preset);
            expect_no_holes_around(stage, open_origins(stage.level), 40, 4);
        }
}

OBLONG_FOR_REAL_LEVELS(RealHoles);

}  // namespace oblong::test

// Eyes in walls and behind the sky: what faces them is drawn, wherever it is, and the rest of the picture is colour 0.
// The reference is a ray through the middle of a pixel, in doubles, against every face of the world.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/frame/holes.h"
#include "tests/support/point.h"

namespace oblong::test {

namespace {

/// From the eye through the middle of a pixel of 320x200 on 4:3, 90 degrees across; no roll.
Point ray_through(const Camera& camera, int column, int row) {
    const double turn = 6.283185307179586 / 65536, yaw = camera.yaw.bam * turn, pitch = camera.pitch.bam * turn;
    const double right = (column + 0.5 - 160) / 160, up = -(row + 0.5 - 100) / 100 * 0.75;
    const Point ahead{std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch), -std::sin(pitch)};
    const Point rightward{std::sin(yaw), -std::cos(yaw), 0}, upward = cross(rightward, ahead);
    return ahead + rightward * right + upward * up;
}

/// Whether a ray passes through a face from its front, well inside (1) or in doubt (0); -1: surely not.
int passes(const Level& level, const FaceTable& table, FaceIndex face, const Point& eye, const Point& ray) {
    const std::span<const VertexIndex> corners = table.corners_of(face);
    constexpr double kDoubt = 1e-2;
    int verdict = 1;
    double volume = 0;  // above 0 from the front
    const Point start = to_point(level.vertices[corners[0]]) - eye;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point a = to_point(level.vertices[corners[i]]) - eye;
        const Point b = to_point(level.vertices[corners[(i + 1) % corners.size()]]) - eye;
        const Point normal = cross(a, b);  // inward, as corners run clockwise
        volume += dot(normal, start);
        const double distance = dot(normal, ray) / (std::sqrt(dot(normal, normal) * dot(ray, ray)) + 1e-30);
        if (distance < -kDoubt) return -1;
        if (distance < kDoubt) verdict = 0;
    }
    return volume > 0 ? verdict : -1;
}

enum class Surely { Something, Nothing, InDoubt };

Surely what_is_before(const Level& level, const FaceTable& table, const Point& eye, const Point& ray) {
    bool any_doubt = false;
    for (const FaceIndex face : level.world().faces) {
        const int verdict = passes(level, table, face, eye, ray);
        if (verdict > 0) return Surely::Something;
        any_doubt |= verdict == 0;
    }
    return any_doubt ? Surely::InDoubt : Surely::Nothing;
}

Camera random_camera_in(const Level& level, std::int32_t contents, std::mt19937& random) {
    const LevelBox& box = level.world().box;
    const auto within = [&](std::size_t axis) {
        const std::int32_t size = box.maxs[axis] - box.mins[axis];
        return World::from_int(box.mins[axis] + static_cast<std::int32_t>(random() % static_cast<unsigned>(size)));
    };
    Camera camera;
    for (int tries = 0; tries < 100'000; ++tries) {
        camera.eye = {within(0), within(1), within(2)};
        // Off the grid, so that the eye is where it is put.
        camera.eye.x.raw += 1234, camera.eye.y.raw += 2345, camera.eye.z.raw += 3456;
        if (level.leaves[find_leaf(level, level.world(), camera.eye)].contents == contents) break;
    }
    camera.yaw = Angle::from_bam(random());
    camera.pitch = Angle::from_bam(random() % 32768 - 16384);
    return camera;
}

struct Tally {
    int something = 0, nothing = 0;
};

/// Draws over a buffer of rubbish, and asks 60 pixels.
void check_picture(Stage& stage, const Camera& camera, ObservedWorkspace& work, std::mt19937& random, Tally& tally) {
    std::fill(stage.pixels.begin(), stage.pixels.end(), static_cast<std::uint8_t>(random()));
    stage.draw(camera, work);
    for (std::size_t i = 0; i < stage.pixels.size(); ++i) {
        ASSERT_LE(work.counts.writes[i], 1);
        ASSERT_TRUE(work.counts.writes[i] == 1 || stage.pixels[i] == 0);
    }
    for (int i = 0; i < 60; ++i) {
        const int column = static_cast<int>(random() % 320), row = static_cast<int>(random() % 200);
        const Surely before =
            what_is_before(stage.level, work.cache.faces, to_point(camera.eye), ray_through(camera, column, row));
        if (before == Surely::InDoubt) continue;
        ++(before == Surely::Something ? tally.something : tally.nothing);
        ASSERT_EQ(work.counts.writes[static_cast<std::size_t>(row * 320 + column)], before == Surely::Something)
            << describe(camera, 0, 0) << " at " << column << ", " << row;
    }
}

class WalledIn : public testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(WalledIn, HardCaseV14_InAWallAllThatFacesTheEyeIsDrawnAndTheRestIsColour0) {
    OBLONG_NEEDS_SHARED_LEVELS();
    Stage stage = real_stage(GetParam());
    stage.models.clear();
    const auto work = counting_workspace(stage);
    std::mt19937 random(14);
    Tally tally;
    for (int i = 0; i < 120 && !HasFatalFailure(); ++i)
        check_picture(stage, random_camera_in(stage.level, contents::kSolid, random), *work, random, tally);
    EXPECT_GT(tally.something, 100);
    EXPECT_GT(tally.nothing, 100);
}

INSTANTIATE_TEST_SUITE_P(Levels, WalledIn, testing::ValuesIn(kRealLevels), [](const auto& name) { return name.param; });

TEST(BehindTheSky, HardCaseV14_AllThatFacesTheEyeIsDrawn) {
    Stage stage = demo_stage();
    stage.models.clear();
    stage.settings.allowed_effects = EffectSet{}.with(Effect::Sky).with(Effect::Liquid);  // no things before the void
    const auto work = counting_workspace(stage);
    std::mt19937 random(15);
    Tally tally;
    for (int i = 0; i < 60 && !HasFatalFailure(); ++i)
        check_picture(stage, random_camera_in(stage.level, contents::kSky, random), *work, random, tally);
    EXPECT_GT(tally.something, 100);
    EXPECT_GT(tally.nothing, 100);
}

TEST(OutOfTheWorld, LookingAwayIsColour0FromEdgeToEdge) {
    Stage stage = demo_stage();
    ObservedWorkspace work(stage.level, stage.mode);
    Camera camera;
    camera.eye = {World::from_int(-9000), World::from_int(0), World::from_int(0)};
    camera.yaw = Angle::from_bam(32768);
    std::fill(stage.pixels.begin(), stage.pixels.end(), std::uint8_t{0x5a});
    stage.draw(camera, work);
    EXPECT_EQ(std::count(stage.pixels.begin(), stage.pixels.end(), 0), 320 * 200);
}

}  // namespace oblong::test

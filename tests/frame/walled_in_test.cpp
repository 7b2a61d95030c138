// Eyes in walls and behind the sky: what faces them is drawn, wherever it is, and the rest of the picture is colour 0.
// The reference is a ray through the middle of a pixel, in doubles, against every face of the world.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/frame/holes.h"
#include "tests/support/random.h"
#include "tests/support/views.h"

namespace oblong::test::walled_in_test {

namespace {

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
    Camera camera;
    for (int tries = 0; tries < 100'000; ++tries) {
        camera.eye = random_point_in(level.world().box, random);
        if (level.leaves[find_leaf(level, level.world(), camera.eye)].contents == contents) break;
    }
    camera.yaw = random_angle(random);
    camera.pitch = Angle::from_bam(random_below(random, 32768) - 16384);
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
    const TrueCamera truth(camera);
    for (int i = 0; i < 60; ++i) {
        const int column = random_below(random, 320), row = random_below(random, 200);
        const Surely before =
            what_is_before(stage.level, work.cache.faces, truth.eye, truth.through_pixel(column, row));
        if (before == Surely::InDoubt) continue;
        ++(before == Surely::Something ? tally.something : tally.nothing);
        ASSERT_EQ(work.counts.writes[static_cast<std::size_t>(row * 320 + column)], before == Surely::Something)
            << describe(camera, 0, 0) << " at " << column << ", " << row;
    }
}

class WalledIn : public OfLevel {};

}  // namespace

TEST_P(WalledIn, HardCaseV14_InAWallOrBehindTheSkyAllThatFacesTheEyeIsDrawnAndTheRestIsColour0) {
    Stage stage = stage_named(GetParam());
    stage.models.clear();
    stage.settings.allowed_effects = EffectSet{}.with(Effect::Sky).with(Effect::Liquid);  // no things before the void
    const auto work = counting_workspace(stage);
    std::mt19937 random(14);
    Tally tally;
    const std::int32_t around = is_demo() ? contents::kSky : contents::kSolid;
    for (int i = 0; i < (is_demo() ? 60 : 120) && !HasFatalFailure(); ++i)
        check_picture(stage, random_camera_in(stage.level, around, random), *work, random, tally);
    EXPECT_GT(tally.something, 100);
    EXPECT_GT(tally.nothing, 100);
}

OBLONG_FOR_ALL_LEVELS(WalledIn);

TEST(OutOfTheWorld, LookingAwayIsColour0FromEdgeToEdge) {
    Stage stage = demo_stage();
    ObservedWorkspace work(stage.level, stage.mode);
    const Camera camera = camera_at(point_at(-9000, 0, 0), 180);
    std::fill(stage.pixels.begin(), stage.pixels.end(), std::uint8_t{0x5a});
    stage.draw(camera, work);
    EXPECT_EQ(std::count(stage.pixels.begin(), stage.pixels.end(), 0), 320 * 200);
}

}  // namespace oblong::test::walled_in_test

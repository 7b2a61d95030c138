#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/visibility/eye.h"
#include "tests/frame/holes.h"
#include "tests/support/random.h"
#include "tests/support/views.h"

namespace oblong::test::walled_in_test {
namespace {

// Eyes in walls and behind the sky: what faces them is drawn, wherever it is, and the rest of the picture is colour 0.
// The reference is a ray through the middle of a pixel, in doubles, against every face of the world.

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

// Eyes where engines fail: exactly on corners, on edges, in faces; at fields of view from 1 to 178 degrees; with doors
// and lifts at any offset. Every pixel is written once all the same. And eyes where nobody should be: in a wall, behind
// the sky.

enum class On { Corner, Edge, Face };

Vec3<World> between(const Vec3<World>& a, const Vec3<World>& b, std::int32_t part_of_64) {
    return to_world(along(to_point(a), to_point(b), part_of_64 / 64.0));
}

/// A point of a face of the world.
Vec3<World> point_on_a_face(const Level& level, const FaceTable& table, On on, std::mt19937& random) {
    const IndexRange<Face> faces = level.world().faces;
    const auto number = static_cast<std::int32_t>(random() % static_cast<unsigned>(faces.count));
    const std::span<const VertexIndex> corners = table.corners_of(FaceIndex(faces.first.number() + number));
    const std::size_t first = random() % corners.size();
    const auto corner = [&](std::size_t i) { return level.vertices[corners[(first + i) % corners.size()]]; };
    const auto part = [&] { return random_below(random, 65); };
    if (on == On::Corner) return corner(0);
    const Vec3<World> on_edge = between(corner(0), corner(1), part());
    return on == On::Edge ? on_edge : between(on_edge, corner(2), part());
}

Camera random_view_from(const Vec3<World>& eye, std::mt19937& random) {
    const Angle pitch = Angle::from_bam(random_below(random, 32768) - 16384);
    Camera camera{eye, random_angle(random), pitch, random() % 3 ? Angle{} : random_angle(random)};
    constexpr std::array<int, 6> kExtremes{1, 5, 30, 150, 170, 178};
    camera.field_of_view =
        Degrees::from_int(random() % 2 ? kExtremes[random() % kExtremes.size()] : 1 + static_cast<int>(random() % 178));
    return camera;
}

bool is_place_open(const Level& level, const Vec3<World>& eye) {
    return is_open(level, place_eye(level, eye).position);
}

class HardEyes : public OfLevel {};

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
TEST_P(HardEyes, HardCaseV13_NoHoleFromCornersEdgesAndFaces) {
    Stage stage = stage_named(GetParam());
    const auto work = counting_workspace(stage);
    std::mt19937 random(13);
    for (int i = 0; i < 2000 && !HasFailure(); ++i) {
        const On on = std::array{On::Corner, On::Edge, On::Face}[static_cast<std::size_t>(i % 3)];
        const Vec3<World> eye = point_on_a_face(stage.level, work->cache.faces, on, random);
        stage.settings.accuracy = accuracy_of(i % 2 ? Preset::Bounded : Preset::Year1991);
        if (is_place_open(stage.level, eye)) expect_each_pixel_once(stage, random_view_from(eye, random), *work);
    }
}

TEST_P(HardEyes, HardCaseV13_EyesOnCornersAreMovedClearOfAllPlanes) {
    const Stage stage = stage_named(GetParam());
    const FaceTable table = make_face_table(stage.level);
    for (const FaceIndex face : stage.level.world().faces)
        for (const VertexIndex corner : table.corners_of(face)) {
            const Vec3<World> eye = stage.level.vertices[corner];
            const PlacedEye placed = place_eye(stage.level, eye);
            NodeChild at = stage.level.world().root;
            double nearest = 1;
            while (!at.is_leaf()) {
                const Node& node = stage.level.nodes[at.node()];
                const LevelPlane& plane = stage.level.planes[node.plane];
                nearest = std::min(nearest, std::abs(number_of(plane_distance(plane, placed.position))));
                at = node.children[plane_side(plane, placed.position) > 0 ? 0 : 1];
            }
            ASSERT_GE(nearest, 1.0 / 2048) << "corner " << corner.number();
            ASSERT_NE(stage.level.leaves[placed.leaf].contents, contents::kSolid) << corner.number();
        }
}

TEST_P(HardEyes, NoHoleWithModelsAtAnyOffset) {
    Stage stage = stage_named(GetParam());
    const auto work = counting_workspace(stage);
    std::mt19937 random(14);
    for (int i = 0; i < 500 && !HasFailure(); ++i) {
        constexpr std::array<std::int32_t, 6> kOffsets{0, 0, 1024, 4096 * 17, -4096 * 32, 4096 * 64 + 77};
        const auto offset = [&] { return World::from_raw(kOffsets[random() % kOffsets.size()]); };
        for (PlacedModel& model : stage.models) model.offset = {offset(), offset(), offset()};
        const Vec3<World> eye = point_on_a_face(stage.level, work->cache.faces, On::Face, random);
        stage.settings.accuracy = accuracy_of(i % 2 ? Preset::Bounded : Preset::Year1991);
        if (is_place_open(stage.level, eye)) expect_each_pixel_once(stage, random_view_from(eye, random), *work);
    }
}

OBLONG_FOR_ALL_LEVELS(HardEyes);
}  // namespace oblong::test::walled_in_test

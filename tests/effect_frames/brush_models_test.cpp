// Pictures of brush models that stand in each other and in mirrors, held against rays through the boxes themselves.

#include <random>

#include "tests/effect_frames/effect_stage.h"
#include "tests/support/palettes.h"
#include "tests/support/random.h"

namespace oblong::test::brush_models_test {
namespace {

struct ColouredBox {
    Whole mins, maxs;
    std::string texture;
    std::uint8_t colour;
};

/// The colour of the box that a ray meets first; none where two of different colours are as near as rounding. A mirror
/// faces -x, and shows what the reflected ray meets; `is_reflected`: the ray comes from it.
std::optional<std::uint8_t> colour_along(const std::vector<ColouredBox>& boxes, const Point& eye, const Point& ray,
                                         bool is_reflected = false) {
    std::uint8_t colour = kWall;
    double nearest = 1e9;
    bool is_tie = false;
    for (const ColouredBox& box : boxes) {
        const auto [entry, exit] = passage_of(eye, ray, place_of(box.mins), place_of(box.maxs));
        if (std::max(entry, 0.0) >= exit) continue;
        if (std::abs(entry - nearest) < 0.01)
            is_tie |= box.colour != colour;
        else if (entry < nearest)
            nearest = entry, colour = box.colour, is_tie = false;
    }
    if (is_tie) return std::nullopt;
    if (colour != kMirror || is_reflected) return colour;
    const Point before_mirror = eye + ray * nearest - Point{1e-6, 0, 0};
    return colour_along(boxes, before_mirror, {-ray.x, ray.y, ray.z}, true);
}

MapText room_of(const std::vector<ColouredBox>& boxes) {
    MapText text{room({-256, -256, -256}, {256, 256, 256}), entity_at("info_player_start", {-240, -240, -200}), {}};
    for (const ColouredBox& one : boxes) text.entities += entity("func_wall", {}, box(one.mins, one.maxs, one.texture));
    return text;
}

/// Draws the boxes and compares the pixels that rays decide. `moved`: how far the level has them from their places.
void expect_nearest_boxes(const std::vector<ColouredBox>& boxes, const Whole& eye, double yaw,
                          const Whole& moved = {}) {
    std::vector<ColouredBox> built = boxes;
    for (ColouredBox& one : built)
        for (std::size_t axis = 0; axis < 3; ++axis) one.mins[axis] -= moved[axis], one.maxs[axis] -= moved[axis];
    EffectStage stage(room_of(built), camera_at(to_world(place_of(eye)), yaw), unshaded());
    ASSERT_EQ(stage.models.size(), boxes.size());
    for (PlacedModel& model : stage.models) model.offset = to_world(place_of(moved));
    const Picture picture = stage.draw_without(Effect::AnimatedTextures);
    const TrueCamera camera(stage.camera);
    int wrong = 0, decided = 0, of_models = 0;
    for (int pixel = 0; pixel < kPicturePixels; ++pixel) {
        const auto expected = at_all_rays(camera, pixel % kPictureWidth, pixel / kPictureWidth, 0.05,
                                          [&](const Point& ray) { return colour_along(boxes, camera.eye, ray); });
        if (!expected || !*expected) continue;
        ++decided;
        of_models += *expected != kWall;
        wrong += picture[static_cast<std::size_t>(pixel)] != *expected;
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(decided, 55'000);
    EXPECT_GT(of_models, 2'000);
}

TEST(BrushModels, ThatReachIntoEachOtherShowTheNearest) {
    std::mt19937 random(8);
    const auto between = [&](int low, int high) { return low + random_below(random, high - low); };
    for (int scene = 0; scene < 12; ++scene) {
        SCOPED_TRACE(scene);
        std::vector<ColouredBox> boxes{{{}, {}, "floor", kFloor},
                                       {{}, {}, "other", kOther},
                                       {{}, {}, "+0sign", kSign0},
                                       {{}, {}, "+1sign", kSign1}};
        for (ColouredBox& box : boxes) {
            box.mins = {between(-40, 20), between(-60, 30), between(-60, 20)};
            for (std::size_t axis = 0; axis < 3; ++axis) box.maxs[axis] = box.mins[axis] + between(20, 90);
        }
        expect_nearest_boxes(boxes, {-210, between(-80, 80), between(-60, 60)}, between(-11, 11));
    }
}

TEST(BrushModels, ALongThinOneBeforeALargeOneShowsThoughItsMiddleIsFarther) {
    expect_nearest_boxes(
        {{{-60, 40, -20}, {-50, 250, 20}, "other", kOther}, {{-40, -40, -100}, {60, 90, 100}, "floor", kFloor}},
        {-200, 0, 0}, 0);
}

/// Where their faces are in one plane, the model whose middle is nearer shows, and of equal ones the first.
TEST(BrushModels, WithFacesInOnePlaneHaveAnOrder) {
    const auto shown = [](int depth_of_floor, int depth_of_other) {
        const auto boxed = [](int depth, const char* texture) {
            return ColouredBox{{-40, -60, -60}, {depth - 40, 60, 60}, texture, 0};
        };
        EffectStage stage(room_of({boxed(depth_of_floor, "floor"), boxed(depth_of_other, "other")}),
                          camera_at(point_at(-200, 3, 2), 0));
        stage.draw();
        return stage.texture_at(100 * kPictureWidth + 160);
    };
    EXPECT_EQ(shown(40, 80), "floor");
    EXPECT_EQ(shown(80, 40), "other");
    EXPECT_EQ(shown(40, 40), "floor");
}

/// Boxes before the mirror, beside it, and behind it, where it must not show them; one reaches through its plane.
TEST(Mirrors, ShowWhatIsBeforeThem) {
    const std::vector<ColouredBox> boxes{{{100, -120, -90}, {104, 120, 90}, "mirror", kMirror},
                                         {{20, -60, -40}, {50, -10, 30}, "floor", kFloor},
                                         {{-220, 60, -80}, {-190, 110, 80}, "other", kOther},
                                         {{120, 20, -30}, {180, 80, 40}, "+0sign", kSign0},
                                         {{60, 121, -60}, {200, 140, 60}, "+1sign", kSign1}};
    expect_nearest_boxes(boxes, {-100, 0, 0}, 0);
    expect_nearest_boxes(boxes, {-60, 90, 40}, -16.5);
    expect_nearest_boxes(boxes, {70, -100, 10}, 49.5);
    expect_nearest_boxes(boxes, {-60, 90, 40}, -16.5, {30, -20, 10});
}

/// A liquid that only a brush model has is on the frame's plan, and not without that model.
TEST(BrushModels, BringTheirOwnEffectsToAFrame) {
    EffectStage stage(room_of({{{0, -40, -40}, {20, 40, 40}, "*water", kWater}}), camera_at(point_at(-200, 0, 0), 0));
    stage.draw();
    EXPECT_TRUE(stage.has(Effect::Liquid) && stage.has(Effect::BrushModels));
    stage.models.clear();
    stage.draw();
    EXPECT_EQ(stage.work.plan.effects, EffectSet{});
}

}  // namespace
}  // namespace oblong::test::brush_models_test

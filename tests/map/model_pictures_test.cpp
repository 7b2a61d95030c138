#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "tests/map/map_source.h"
#include "tools/reference/vec.h"

// Pictures of brush models that stand in each other, held against rays through the boxes themselves.
namespace oblong::test {
namespace {

struct TexturedBox {
    Whole mins, maxs;
    std::string texture;
    std::uint8_t colour;  ///< of the texture, in the WAD of compile()
};

constexpr Whole kRoomMins{-256, -256, -256}, kRoomMaxs{256, 256, 256};
constexpr std::uint8_t kRoomColour = 1;

using Direction = reference::Vec;

/// Where a ray from outside enters a box; nothing if it misses.
std::optional<double> entry_of(const TexturedBox& box, const Direction& eye, const Direction& ray) {
    double enter = 0, leave = 1e9;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double near = (box.mins[axis] - eye[axis]) / ray[axis], far = (box.maxs[axis] - eye[axis]) / ray[axis];
        if (near > far) std::swap(near, far);
        enter = std::max(enter, near);
        leave = std::min(leave, far);
    }
    return enter < leave ? std::optional(enter) : std::nullopt;
}

constexpr std::uint8_t kMirrorColour = 9;

/// The colour of the box that a ray meets first; none where two of different colours are as near as rounding. A mirror
/// faces -x, and shows what the reflected ray meets; `is_reflected`: the ray comes from it.
std::optional<std::uint8_t> colour_along(const std::vector<TexturedBox>& boxes, const Direction& eye,
                                         const Direction& ray, bool is_reflected = false) {
    std::uint8_t colour = kRoomColour;
    double nearest = 1e9;
    bool is_tie = false;
    for (const TexturedBox& box : boxes) {
        const auto entry = entry_of(box, eye, ray);
        if (!entry) continue;
        if (std::abs(*entry - nearest) < 0.01)
            is_tie |= box.colour != colour;
        else if (*entry < nearest)
            nearest = *entry, colour = box.colour, is_tie = false;
    }
    if (is_tie) return std::nullopt;
    if (colour != kMirrorColour || is_reflected) return colour;
    const Direction hit{eye[0] + ray[0] * nearest - 1e-6, eye[1] + ray[1] * nearest, eye[2] + ray[2] * nearest};
    return colour_along(boxes, hit, {-ray[0], ray[1], ray[2]}, true);
}

/// The ray through a place on the 320x200 screen at 90 degrees, looking along yaw (Muratori's multipliers: 160 across,
/// 160 * 4/3 * 200/320 down).
Direction ray_through(double column, double row, double yaw) {
    const double x = (column - 160) / 160, y = (100 - row) / (160 * 4.0 / 3 * 200 / 320);
    return {std::cos(yaw) + x * std::sin(yaw), std::sin(yaw) - x * std::cos(yaw), y};
}

/// What a pixel shows; none at an edge, where rounding decides.
std::optional<std::uint8_t> expected_colour(const std::vector<TexturedBox>& boxes, const Direction& eye, int column,
                                            int row, double yaw) {
    std::optional<std::uint8_t> colour;
    for (const double dx : {0.45, 0.55})
        for (const double dy : {0.45, 0.55}) {
            const auto found = colour_along(boxes, eye, ray_through(column + dx, row + dy, yaw));
            if (!found || (colour && *colour != *found)) return std::nullopt;
            colour = found;
        }
    return colour;
}

Level compile_boxes(const std::vector<TexturedBox>& boxes) {
    std::string models;
    for (const TexturedBox& one : boxes) models += entity("func_wall", {}, box(one.mins, one.maxs, one.texture));
    return engine_level(compile(
        level(room(kRoomMins, kRoomMaxs), entity_at("info_player_start", {-240, -240, -200}) + models), {true}));
}

/// Colours as they are, however dark: the source has no lights.
Colormap same_in_every_shade() {
    Colormap map;
    for (auto& shade : map.shades)
        for (std::size_t i = 0; i < 256; ++i) shade[i] = static_cast<std::uint8_t>(i);
    return map;
}

/// Draws the boxes from an eye and compares the pixels that rays decide.
void expect_nearest_boxes(const std::vector<TexturedBox>& boxes, const Whole& eye, std::int64_t yaw_bam) {
    const Level level = compile_boxes(boxes);
    const Colormap colormap = same_in_every_shade();
    const std::vector<PlacedModel> models = models_at_rest(level);
    ASSERT_EQ(models.size(), boxes.size());
    FrameWorkspace work(level, {});
    std::vector<std::uint8_t> pixels(320 * 200);
    Camera camera;
    camera.eye = {World::from_int(eye[0]), World::from_int(eye[1]), World::from_int(eye[2])};
    camera.yaw = Angle::from_bam(yaw_bam);
    Settings settings;  // +0lamp and +1lamp are to be two colours
    settings.allowed_effects = settings.allowed_effects.without(Effect::AnimatedTextures);
    draw_frame({level, colormap, models}, camera, {}, settings, work, {pixels.data(), 320, 200, 320});

    const double yaw = static_cast<double>(yaw_bam) / 65536 * 2 * std::numbers::pi;
    const Direction from{1.0 * eye[0], 1.0 * eye[1], 1.0 * eye[2]};
    int wrong = 0, decided = 0, of_models = 0;
    for (int row = 0; row < 200; ++row)
        for (int column = 0; column < 320; ++column) {
            const auto expected = expected_colour(boxes, from, column, row, yaw);
            if (!expected) continue;
            ++decided;
            of_models += *expected != kRoomColour;
            wrong += pixels[static_cast<std::size_t>(row * 320 + column)] != *expected;
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(decided, 55'000);
    EXPECT_GT(of_models, 2'000);
}

TEST(ModelPictures, OfModelsThatReachIntoEachOtherTheNearestShows) {
    std::mt19937 random(8);
    const auto between = [&](int low, int high) { return low + static_cast<int>(random() % unsigned(high - low)); };
    const std::vector<std::pair<std::string, std::uint8_t>> textures{
        {"floor", 2}, {"other", 3}, {"+0lamp", 7}, {"+1lamp", 8}};
    for (int scene = 0; scene < 12; ++scene) {
        SCOPED_TRACE(scene);
        std::vector<TexturedBox> boxes;
        for (const auto& [texture, colour] : textures) {
            const Whole mins{between(-40, 20), between(-60, 30), between(-60, 20)};
            boxes.push_back({mins,
                             {mins[0] + between(20, 90), mins[1] + between(20, 90), mins[2] + between(20, 90)},
                             texture,
                             colour});
        }
        expect_nearest_boxes(boxes, {-210, between(-80, 80), between(-60, 60)}, between(-2000, 2000));
    }
}

/// Boxes before the mirror, beside it, and behind it, where it must not show them; one reaches through its plane.
TEST(ModelPictures, AMirrorShowsWhatIsBeforeIt) {
    const std::vector<TexturedBox> boxes{{{100, -120, -90}, {104, 120, 90}, "mirror", kMirrorColour},
                                         {{20, -60, -40}, {50, -10, 30}, "floor", 2},
                                         {{-220, 60, -80}, {-190, 110, 80}, "other", 3},
                                         {{120, 20, -30}, {180, 80, 40}, "+0lamp", 7},
                                         {{60, 121, -60}, {200, 140, 60}, "+1lamp", 8}};
    expect_nearest_boxes(boxes, {-100, 0, 0}, 0);
    expect_nearest_boxes(boxes, {-60, 90, 40}, -3000);
    expect_nearest_boxes(boxes, {70, -100, 10}, 9000);
}

TEST(ModelPictures, ALongThinModelBeforeALargeOneShowsThoughItsMiddleIsFarther) {
    expect_nearest_boxes({{{-60, 40, -20}, {-50, 250, 20}, "other", 3}, {{-40, -40, -100}, {60, 90, 100}, "floor", 2}},
                         {-200, 0, 0}, 0);
}

/// A liquid that only a brush model has is on the frame's plan, and not without that model.
TEST(ModelPictures, AModelBringsItsOwnEffectsToAFrame) {
    const Level level = compile_boxes({{{0, -40, -40}, {20, 40, 40}, "*water", 4}});
    const std::vector<PlacedModel> models = models_at_rest(level);
    const Colormap colormap = same_in_every_shade();
    FrameWorkspace work(level, {});
    std::vector<std::uint8_t> pixels(320 * 200);
    Camera camera;
    camera.eye = {World::from_int(-200), {}, {}};
    draw_frame({level, colormap, models}, camera, {}, {}, work, {pixels.data(), 320, 200, 320});
    EXPECT_TRUE(work.plan.effects.has(Effect::Liquid));
    EXPECT_TRUE(work.plan.effects.has(Effect::BrushModels));

    draw_frame({level, colormap, {}}, camera, {}, {}, work, {pixels.data(), 320, 200, 320});
    EXPECT_EQ(work.plan.effects, EffectSet{});
}

}  // namespace
}  // namespace oblong::test

#include "engine/view/views.h"
#include "tests/effect_frames/effect_stage.h"

namespace oblong::test {
namespace {

// Fences, and things before and behind them.

/// A fence across a room at x = 0, and a striped wall behind it.
MapText fenced_room(const std::string& entities = "") {
    MapText text = room_with("", entity("func_wall", {}, box({-4, -256, 0}, {4, 256, 192}, "{bars")) + entities);
    for (int y = -240; y < 240; y += 48) text.brushes += box({200, y, 0}, {256, y + 24, 192}, "other");
    return text;
}

Camera before_fence() {
    return camera_at(point_at(-150, 3, 90), 0, 0);
}

std::string lamp_at(const Whole& origin, const std::string& scale = "2") {
    return entity_at("misc_sprite", origin, {{"texture", "{lamp"}, {"scale", scale}});
}

TEST(Fence, ShowsWhatIsBehindItsHoles) {
    EffectStage stage(fenced_room(), before_fence());
    const Picture fenced = stage.draw();
    EXPECT_TRUE(stage.has(Effect::Fence));
    stage.models.clear();
    const Picture open = stage.draw();
    EXPECT_FALSE(stage.has("see_through"));
    std::int64_t bars = 0, holes = 0;
    for (std::size_t i = 0; i < fenced.size(); ++i) {
        ASSERT_TRUE(fenced[i] == kBars || fenced[i] == open[i]);
        ++(fenced[i] == kBars ? bars : holes);
    }
    EXPECT_GT(bars, 20'000);
    EXPECT_GT(holes, 20'000);
}

TEST(Fence, NotAllowedIsAWallWithItsHolesFilled) {
    EffectStage stage(fenced_room(), before_fence());
    stage.draw_without(Effect::Fence);
    EXPECT_FALSE(stage.has("see_through"));
    EXPECT_EQ(stage.pixels(Effect::Fence), stage.pixels(Effect::BrushModels)) << "counted as what needs it";
    for (std::size_t i = 0; i < kPicturePixels; ++i) ASSERT_NE(stage.texture_at(i), "other") << "is behind the fence";
}

TEST(Sprites, BeforeAFenceHideItAndBehindItShowInItsHoles) {
    for (const bool is_before : {true, false}) {
        EffectStage stage(fenced_room(lamp_at({is_before ? -60 : 60, 0, 90})), before_fence());
        const Picture picture = stage.draw();
        EXPECT_TRUE(stage.has(Effect::Sprites));
        const Picture open = stage.draw_without_models();
        const Picture bare = stage.draw_without(Effect::Sprites);
        EXPECT_GT(count_of(picture, kLamp), is_before ? 5'000 : 500);
        for (std::size_t i = 0; i < picture.size(); ++i) {
            const bool is_lamp = open[i] == kLamp && (is_before || bare[i] != kBars);
            ASSERT_EQ(picture[i], is_lamp ? kLamp : bare[i]) << is_before;
        }
    }
}

TEST(Sprites, HideBehindWalls) {
    EffectStage stage(fenced_room(lamp_at({228, -36, 90}, "0.5")), before_fence());  // in a pillar
    EXPECT_EQ(count_of(stage.draw(), kLamp), 0);
    EXPECT_FALSE(stage.has(Effect::Sprites));
}

TEST(Particles, HideBehindWallsAndAppearBefore) {
    const auto dust = [](const Whole& origin) {
        return entity_at("misc_dust", origin, {{"size", "40 200 100"}, {"count", "500"}, {"colour", "211 211"}});
    };
    MapText text =
        room_with("", entity("func_wall", {}, box({0, -256, 0}, {16, 256, 192}, "other")) + dust({120, 0, 80}));
    EffectStage hidden(text, before_fence());
    for (const std::int64_t time_ms : {0, 5'000, 12'345}) {
        EXPECT_EQ(count_of(hidden.draw(time_ms), 211), 0);
        EXPECT_FALSE(hidden.has(Effect::Particles));
        EXPECT_EQ(hidden.pixels(Effect::Particles), 0);
    }
    const PlacedModel wall = hidden.models[0];
    hidden.models.clear();
    EXPECT_GT(count_of(hidden.draw(), 211), 300);
    EXPECT_TRUE(hidden.has(Effect::Particles));
    hidden.models.push_back(wall);
    hidden.models[0].offset.z = World::from_int(-100);  // the wall's lower half sinks into the floor
    const std::int64_t above_it = count_of(hidden.draw(), 211);
    EXPECT_GT(above_it, 50);

    text.entities += dust({-60, 0, 80});
    EffectStage before(text, before_fence());
    EXPECT_GT(count_of(before.draw(), 211), 300);
}

TEST(Shadows, FallOnTheirFloorAndOnNothingElse) {
    const MapText text = room_with(box({10, -100, 0}, {60, 100, 40}, "other"),
                                   entity_at("misc_sprite", {0, 0, 40}, {{"texture", "{lamp"}, {"shadow", "40"}}) +
                                       entity("func_wall", {}, box({-30, 0, -8}, {-10, 30, 0}, "floor")));
    const Camera camera = camera_at(point_at(-150, 3, 120), 0, 30);
    EffectStage stage(text, camera_at(point_at(-150, 3, 120), 0, 10));
    stage.models.at(0).offset = point_at(0, 0, 16);  // its upper side has the floor's plane in the level
    stage.draw();                                    // in other rows
    stage.camera = camera;
    const Picture with = stage.draw();
    EXPECT_TRUE(stage.has("shadows"));
    EXPECT_TRUE(stage.has(Effect::Shadows));
    const std::int64_t owned = stage.pixels(Effect::Shadows);
    const Picture without = stage.draw_without(Effect::Shadows);
    EXPECT_FALSE(stage.has("shadows"));
    std::int64_t dark = 0;
    for (std::size_t i = 0; i < with.size(); ++i) {
        if (with[i] == without[i]) continue;
        ++dark;
        ASSERT_EQ(stage.texture_at(i), "wall");
        const LevelPlane& plane = stage.level.planes[stage.face_at(i)->plane];
        ASSERT_EQ(plane.normal.z, Unit::from_int(1));
        ASSERT_TRUE(with[i] == kWall / 2 || with[i] == kWall / 4);
    }
    EXPECT_GT(dark, 300);
    EXPECT_LE(dark, owned);
    EXPECT_LE(owned, dark + count_of(with, kLamp));
}

// What faces hide is not computed: not a particle, not the depth of a pixel.

struct HiddenThing {
    const char* name;
    const char* entity;
};

/// A room that a wall, 64 units wide and as high as the room, stands in; behind it one thing.
MapText room_with_hidden(const HiddenThing& thing) {
    return room_with(box({-16, -32, 0}, {16, 32, 192}, "other"), entities_of(thing.entity));
}

constexpr HiddenThing kThings[]{
    {"rain", R"(misc_rain 60 0 90 size="16 16 80" count=200)"},
    {"sprite", "misc_sprite 60 0 90 texture={lamp scale=0.25"},
};

class HiddenThings : public testing::TestWithParam<HiddenThing> {};

TEST_P(HiddenThings, AreComputedOnlyFromWhereTheyMayShow) {
    EffectStage stage(room_with_hidden(GetParam()), camera_at(point_at(-150, 0, 90), 0));
    const bool is_rain = std::string_view(GetParam().name) == "rain";
    const auto is_computed = [&] { return stage.work.view.depth.is_wanted(); };
    stage.draw();
    EXPECT_FALSE(is_computed());
    EXPECT_EQ(stage.work.counts.stages.particles, 0);
    stage.camera = camera_at(point_at(-150, 200, 90), -45);  // past the wall
    stage.draw();
    EXPECT_TRUE(is_computed());
    EXPECT_EQ(stage.work.counts.stages.particles > 0, is_rain);
    EXPECT_GT(stage.pixels(Effect::Particles) + stage.pixels(Effect::Sprites), 0);
    stage.camera = camera_at(point_at(120, 0, 90), 180);  // the wall is behind them
    stage.draw();
    EXPECT_TRUE(is_computed());
}

INSTANTIATE_TEST_SUITE_P(Of, HiddenThings, testing::ValuesIn(kThings),
                         [](const auto& each) { return std::string(each.param.name); });

/// Whether all pixels of a dot show the wall.
bool is_behind_wall(const ParticleDot& dot, const EffectStage& stage) {
    for (std::int32_t row = dot.first_row; row < dot.end_row; ++row)
        for (std::int32_t column = dot.first_column; column < dot.end_column; ++column)
            if (stage.texture_at(static_cast<std::size_t>(row * kPictureWidth + column)) != "other") return false;
    return true;
}

/// From eyes all around: each dot that is left out lies on pixels of the wall before it.
TEST(RainBehindAWall, IsLeftOutWhereTheWallHidesIt) {
    constexpr HiddenThing kWideRain{"", R"(misc_rain 60 0 90 size="64 36 80" count=200)"};
    EffectStage stage(room_with_hidden(kWideRain), camera_at(point_at(-150, 0, 90), 0));
    int hidden = 0, shown = 0, partly = 0;
    for (int y = -240; y <= 240; y += 4) {
        stage.camera = camera_at(point_at(-150, y, 90), -y / 5.0);
        stage.draw();
        const std::vector<ParticleDot>& computed = stage.work.view.claims.things.in_view.dots;
        const std::int64_t particles = stage.work.counts.stages.particles;
        (particles == 0 ? hidden : particles == 200 ? shown : partly) += 1;
        ThingsInView in_view;
        DepthBuffer none(kPictureWidth, kPictureHeight);
        const ViewContext view = make_view_context(first_person_view(stage.camera), ScreenMode{}, {});
        find_particles(stage.work.view.things, 0, oblong::Sight{stage.work.view.visible.leaf_set(), view}, in_view,
                       none);
        ASSERT_FALSE(in_view.dots.empty());
        for (const ParticleDot& dot : in_view.dots) {
            const bool is_left_out = std::none_of(computed.begin(), computed.end(), [&](const ParticleDot& other) {
                return other.inverse_depth == dot.inverse_depth && other.first_column == dot.first_column;
            });
            ASSERT_TRUE(!is_left_out || is_behind_wall(dot, stage)) << y;
        }
    }
    EXPECT_GT(hidden, 5);
    EXPECT_GT(partly, 50);
    EXPECT_GT(shown, 5);
}

}  // namespace
}  // namespace oblong::test

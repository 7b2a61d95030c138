// Animated textures and light that changes: the surfaces that show them are never stale, and no other one is built
// again.

#include "engine/platform/worker_threads.h"
#include "tests/effect_frames/effect_stage.h"

namespace oblong::test {
namespace {

MapText sign_room() {
    return room_with(box({100, -100, 40}, {110, -20, 120}, "+0sign"),
                     entity("func_button", {}, box({100, 20, 40}, {110, 100, 120}, "+0sign")));
}

/// The sign's colour at a time: five of three frames a second.
std::uint8_t sign_at(std::int64_t time_ms) {
    constexpr std::array<std::uint8_t, 3> kSigns{kSign0, kSign1, kSign2};
    return kSigns[static_cast<std::size_t>(time_ms / 200 % 3)];
}

TEST(AnimatedTextures, ShowTheFrameOfTheTime) {
    EffectStage stage(sign_room(), camera_at(point_at(-150, 3, 90), 0));
    ASSERT_EQ(stage.models.size(), 1u);
    for (const std::int64_t time_ms : {0, 199, 200, 400, 599, 600, 200, 1'000'000'000}) {
        SCOPED_TRACE(time_ms);
        for (const bool is_pressed : {false, true}) {
            stage.models[0].is_switched = is_pressed;
            const Picture picture = stage.draw(time_ms);
            const std::int64_t signs = stage.pixels(Effect::AnimatedTextures);
            EXPECT_GT(signs, 2'000);
            const std::int64_t on = count_of(picture, kSignOn), off = count_of(picture, sign_at(time_ms));
            EXPECT_EQ(on + off, signs);
            EXPECT_EQ(on > 0, is_pressed);
            EXPECT_EQ(stage.draw_afresh(time_ms), picture);
        }
    }
    constexpr std::int64_t kLate_ms = (std::int64_t{1} << 32) / 600 * 600;
    EXPECT_EQ(stage.draw(kLate_ms + 200), stage.draw(200));
    const Picture still = stage.draw_without(Effect::AnimatedTextures, 200);
    EXPECT_EQ(still, stage.draw_without(Effect::AnimatedTextures, 400));
    EXPECT_FALSE(stage.has(Effect::AnimatedTextures));
}

/// A long room with a light of style 32 at its near end, whose reach does not come to the far one.
MapText lit_room(const std::string& pattern) {
    MapText text;
    text.brushes = room({-1024, -256, 0}, {1024, 256, 192}, 16, "other");
    text.entities = entity_at("info_player_start", {0, 0, 64}) + entity_at("light", {0, 0, 150}, {{"light", "400"}}) +
                    entity_at("light", {-960, 0, 100}, {{"light", "250"}, {"style", "32"}, {"pattern", pattern}});
    return text;
}

Camera down_room() {
    return camera_at(point_at(200, 3, 100), 180);
}

bool has_style(const Face* face) {
    return face && std::find(face->styles.begin(), face->styles.end(), 32) != face->styles.end();
}

TEST(LightStyles, RelightOnlyFacesThatHaveThem) {
    EffectStage stage(lit_room("aazz"), down_room(), shades_as_colours());
    const Picture dark = stage.draw(0);
    const std::int64_t all = stage.work.counts.stages.lit_texels;
    EXPECT_TRUE(stage.has(Effect::Styles));
    EXPECT_EQ(stage.draw(100), dark);
    EXPECT_EQ(stage.work.counts.stages.lit_texels, 0) << "the pattern has not changed";
    const Picture bright = stage.draw(200);
    const std::int64_t relit = stage.work.counts.stages.lit_texels;
    EXPECT_GT(relit, 0);
    EXPECT_LT(relit, all);
    EXPECT_EQ(stage.draw_afresh(200), bright);
    std::int64_t changed = 0, of_others = 0;
    for (std::size_t i = 0; i < bright.size(); ++i) {
        of_others += !has_style(stage.face_at(i));
        if (bright[i] == dark[i]) continue;
        ++changed;
        ASSERT_TRUE(has_style(stage.face_at(i)));
        ASSERT_LT(bright[i], dark[i]) << "the number of a brighter shade is lower";
    }
    EXPECT_GT(changed, 500);
    EXPECT_GT(of_others, 500);
    EXPECT_EQ(stage.draw(400), dark);
    EXPECT_EQ(stage.draw((std::int64_t{1} << 32) / 400 * 400 + 200), bright);
}

TEST(LightStyles, HaveTheTimeOfTheirSurfacesAloneAndOutOfSightCostNothing) {
    for (const int yaw : {0, 180}) {  // out of sight, in sight
        EffectStage stage(lit_room("aazz"), camera_at(point_at(200, 3, 100), yaw), shades_as_colours());
        PassTimes times{ticking_ns};
        stage.work.observers.times = &times;
        const Picture first = stage.draw(0);
        EXPECT_EQ(item(times.effects_ns, Effect::Styles) > 0, yaw == 180);
        EXPECT_EQ(item(times.effects_ns, Effect::AnimatedTextures), 0);
        EXPECT_EQ(stage.has(Effect::Styles), yaw == 180);
        if (yaw == 180) continue;
        EXPECT_EQ(stage.draw(200), first);
        EXPECT_EQ(stage.work.counts.stages.lit_texels, 0);
        EXPECT_EQ(stage.pixels(Effect::Styles), 0);
    }
}

TEST(LightStyles, NotAllowedAreAsStored) {
    EffectStage stage(lit_room("aazz"), down_room(), shades_as_colours());
    EffectStage plain(lit_room("m"), down_room(), shades_as_colours());
    WorkerThreads workers(2);
    FrameWorkspace shared(stage.level, {}, &workers);
    for (const std::int64_t time_ms : {0, 200}) {
        EXPECT_EQ(stage.draw_without(Effect::Styles, time_ms), plain.draw(time_ms));
        stage.settings.allowed_effects = EffectSet::all().without(Effect::Styles);
        EXPECT_EQ(stage.draw_in(shared, time_ms), plain.draw(time_ms)) << "with threads, which find light earlier";
    }
    EXPECT_FALSE(plain.has(Effect::Styles));
}

TEST(LightStyles, FlashesOffAreOneBrightnessAtAllTimes) {
    EffectStage stage(lit_room("aazz"), down_room(), shades_as_colours());
    stage.settings.flashes = Flashes::Off;
    const Picture first = stage.draw(0);
    for (std::int64_t time_ms = 100; time_ms < 1'000; time_ms += 100) EXPECT_EQ(stage.draw(time_ms), first);
    stage.settings.flashes = Flashes::Full;
    EXPECT_NE(stage.draw(0), first);
}

TEST(MovingLights, BrightenWhatTheyReachAndLeaveNothingBehind) {
    EffectStage stage(lit_room("m"), down_room(), shades_as_colours());
    const Picture without = stage.draw();
    EXPECT_FALSE(stage.has(Effect::Lights));
    stage.moving_lights = {{point_at(-400, 100, 20), World::from_int(150)}};
    const Picture with = stage.draw();
    EXPECT_TRUE(stage.has(Effect::Lights));
    const std::int64_t touched = stage.pixels(Effect::Lights);
    EXPECT_EQ(stage.draw_afresh(), with);
    std::int64_t brighter = 0;
    for (std::size_t i = 0; i < with.size(); ++i) {
        ASSERT_LE(with[i], without[i]);
        brighter += with[i] < without[i];
    }
    EXPECT_GT(brighter, 100);
    EXPECT_LE(brighter, touched);
    EXPECT_EQ(stage.draw_without(Effect::Lights), without);
    EXPECT_EQ(stage.pixels(Effect::Lights), 0);
    stage.moving_lights[0].position = point_at(900, 0, 100);  // behind the eye
    EXPECT_EQ(stage.draw(), without);
    EXPECT_FALSE(stage.has(Effect::Lights));
    stage.moving_lights.clear();
    EXPECT_EQ(stage.draw(), without);
}

// The light reaches nothing but the box where it is now, 400 units from its place in the level.
TEST(MovingLights, ReachABrushModelWhereItIsPlaced) {
    MapText text = lit_room("m");
    text.entities += entity("func_wall", {}, box({-100, -40, 20}, {-60, 40, 100}, "other"));
    EffectStage stage(text, down_room(), shades_as_colours());
    const std::vector<MovingLight> lights{{point_at(-440, 0, 60), World::from_int(40)}};
    stage.moving_lights = lights;
    const Picture in_place = stage.draw();
    EXPECT_FALSE(stage.has(Effect::Lights));
    stage.models.at(0).offset = point_at(-400, 0, 0);
    PassTimes times{ticking_ns};
    stage.work.observers.times = &times;
    const Picture moved = stage.draw();
    stage.work.observers.times = nullptr;
    EXPECT_TRUE(stage.has(Effect::Lights));
    EXPECT_GT(item(times.effects_ns, Effect::Lights), 0) << "its surface is timed as lit";
    stage.moving_lights.clear();
    EXPECT_GT(changed_pixels(stage.draw(), moved), 100);
    stage.models.at(0).offset = {};
    EXPECT_EQ(stage.draw(), in_place);
}

}  // namespace
}  // namespace oblong::test

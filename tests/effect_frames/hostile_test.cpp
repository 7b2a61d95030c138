// Levels that call for far too much: a stated limit with a warning, or a picture, and never worse.

#include <algorithm>
#include <set>

#include "engine/frame/mirror_pass.h"
#include "tests/effect_frames/effect_stage.h"

namespace oblong::test {
namespace {

Camera in_room() {
    return camera_at(point_at(-200, 3, 100), 0, 10);
}

MapText plain_box() {
    return room_with("", entity_at("light", {0, 0, 120}), "other");
}

int warnings_with(const std::vector<std::string>& warnings, const std::string& part) {
    return static_cast<int>(std::count_if(warnings.begin(), warnings.end(), [&](const std::string& warning) {
        return warning.find(part) != std::string::npos;
    }));
}

/// Draws at several times, 2^62 ms among them, each the same in a fresh workspace.
void expect_same_afresh(EffectStage& stage) {
    for (const std::int64_t time_ms : {std::int64_t{0}, std::int64_t{1'234}, std::int64_t{1} << 62})
        ASSERT_EQ(stage.draw(time_ms), stage.draw_afresh(time_ms)) << time_ms;
}

TEST(Hostile, TenThousandMovingLights) {
    EffectStage stage(plain_box(), in_room(), shades_as_colours());
    const Picture dark = stage.draw();
    for (int i = 0; i < 10'000; ++i)
        stage.moving_lights.push_back(
            {point_at(i % 100 * 5 - 250, i / 100 * 5 - 250, 10 + i % 170), World::from_int(i % 300), i % 1000});
    EXPECT_NE(stage.draw(), dark);
    expect_same_afresh(stage);
    const World far = World::highest(), near = World::lowest();
    stage.moving_lights.assign(10'000, {{far, far, far}, far, 1 << 30});
    stage.moving_lights.push_back({{near, near, near}, near, -(1 << 30)});
    EXPECT_EQ(stage.draw(), dark) << "out of reach";
    for (MovingLight& light : stage.moving_lights) light.position = in_room().eye;
    expect_same_afresh(stage);
}

/// How many of each count: Things.HaveLimits.
TEST(Hostile, TooManyThings) {
    Level level = compile_effects(plain_box());
    const auto add = [&](std::size_t count, Entity entity) {
        entity.pairs.emplace_back("origin", "0 0 80");
        level.entities.insert(level.entities.end(), count, entity);
    };
    add(10'000, {{{"classname", "misc_lantern"},
                  {"texture", "other"},
                  {"light", "2048"},
                  {"radius", "4096"},
                  {"period", "0.05"}}});
    add(200, {{{"classname", "misc_sparks"}, {"size", "400 400 150"}, {"count", "1000"}}});
    add(5'000, {{{"classname", "misc_sprite"}, {"texture", "other"}, {"scale", "0.25"}, {"shadow", "512"}}});
    add(10, {{{"classname", "misc_sprite"}, {"texture", "no_such"}}});
    EffectStage stage(std::move(level), in_room());
    EXPECT_EQ(stage.work.cache.things.lanterns.size(), kMostLanterns);
    EXPECT_EQ(stage.work.cache.things.sprites.size(), kMostSprites);
    EXPECT_EQ(warnings_with(stage.work.cache.things.warnings, "more than 64"), 10'000 - 64);
    EXPECT_EQ(warnings_with(stage.work.cache.things.warnings, "no_such"), 10);
    expect_same_afresh(stage);
    EXPECT_GT(stage.pixels(Effect::Particles), 10'000);
}

TEST(Hostile, FourThousandBrushModels) {
    MapText text = plain_box();
    for (int i = 0; i < 4'096; ++i) {
        const int x = i % 16 * 24 - 180, y = i / 16 % 16 * 30 - 240, z = i / 256 * 11 + 2;
        text.entities += entity("func_wall", {}, box({x, y, z}, {x + 8, y + 8, z + 6}, i % 2 ? "other" : "*slime"));
    }
    EffectStage stage(text, in_room());
    EXPECT_EQ(stage.models.size(), 4'096u);
    EXPECT_EQ(stage.draw(), stage.draw_afresh());
    EXPECT_GT(stage.pixels(Effect::BrushModels), 20'000);
    for (int i = 0; i < 4'096; ++i)  // all into each other
        stage.models[static_cast<std::size_t>(i)].offset = point_at(i % 7 - i % 16 * 24, i % 5 - i / 16 % 16 * 30, 0);
    EXPECT_EQ(stage.draw(), stage.draw_afresh());
}

TEST(Hostile, FogAtTheEndsOfItsRange) {
    for (const char* fog : {"64 1 1 1", "0.00001 0 0 0", "64 1 1 1 1 0 0.001", "64 1 1 1 1 262143 262144",
                            "64 1 1 1 1 0 262144 262144 262144", "64 1 1 1 1 0 262144 -262144 0.001",
                            "64 1 1 1 1 0 262144 100 0.001", "64 1 1 1 0.001"}) {
        SCOPED_TRACE(fog);
        Level level = compile_effects(plain_box());
        level.entities[0].pairs.emplace_back("fog", fog);
        EffectStage stage(std::move(level), in_room());
        EXPECT_TRUE(stage.work.cache.effects.warnings.empty());
        expect_same_afresh(stage);
    }
}

/// Half of a ball's four hundred sides face the eye; each but kMostMirrors is a wall.
TEST(Hostile, TwoHundredMirrors) {
    MapText text = plain_box();
    text.entities += entity("func_wall", {}, ball({0, 0, 100}, 80, 20, 20, "mirror"));
    EffectStage stage(text, in_room());
    expect_same_afresh(stage);
    EXPECT_GT(stage.pixels(Effect::Mirror), 5'000);
    const std::int64_t walls = count_of(stage.draw(), kMirror);
    EXPECT_GT(walls, 1'000);
    EXPECT_LT(walls, stage.pixels(Effect::Mirror)) << "some of them are mirrors";
}

/// Those that are walls look like walls also in fog, and lit by a moving light.
TEST(Hostile, MirrorsThatAreWallsAreInFogAndLit) {
    MapText text = plain_box();
    text.entities += entity("func_wall", {}, ball({0, 0, 100}, 80, 20, 20, "mirror"));
    text.world_keys = {{"fog", "0.5 0.9 0.9 0.9"}};
    EffectStage stage(text, in_room(), shades_as_colours());
    stage.moving_lights = {{point_at(-120, 0, 100), World::from_int(200)}};
    const Picture walls = stage.draw_without(Effect::Mirror), with_mirrors = stage.draw();
    std::set<std::uint32_t> seen, changed;
    for (std::size_t pixel = 0; pixel < walls.size(); ++pixel) {
        const Face* const face = stage.face_at(pixel);
        if (!face || stage.texture_at(pixel) != "mirror") continue;
        seen.insert(face->plane.number());
        if (with_mirrors[pixel] != walls[pixel]) changed.insert(face->plane.number());
    }
    EXPECT_GT(seen.size(), 50u);
    EXPECT_EQ(changed.size(), kMostMirrors);
}

TEST(Hostile, AThousandFacesThatAreSeenThrough) {
    MapText text = plain_box();
    for (int i = 0; i < 500; ++i)
        text.entities += entity(
            "func_wall", {}, box({i - 150, -200 + i % 3, 2}, {i - 149, 200 - i % 7, 180}, i % 2 ? "{bars" : "*slime"));
    text.world_keys = {{"slimealpha", "0.1"}, {"fog", "1 0.5 0.5 0.5"}};
    EffectStage stage(text, in_room());
    EXPECT_EQ(stage.models.size(), 500u);
    expect_same_afresh(stage);
    EXPECT_GT(stage.pixels("see_through"), 1'000'000);
}

TEST(Hostile, EyesInThePlaneOfAMirrorAndOfASheetOfWater) {
    MapText text = plain_box();
    text.brushes += box({-256, -256, 0}, {256, 256, 100}, "*water");
    text.entities += entity("func_wall", {}, box({0, -100, 30}, {8, 100, 160}, "mirror"));
    text.world_keys = {{"wateralpha", "0.5"}};
    EffectStage stage(text, in_room());
    for (const double x : {-0.001, 0.0, 0.001, 4.0})
        for (const double z : {99.999, 100.0, 100.001}) {
            stage.camera = camera_at(point_at(x, 3, z), 170, 1);
            expect_same_afresh(stage);
        }
}

}  // namespace
}  // namespace oblong::test

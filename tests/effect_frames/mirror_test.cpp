// Mirrors: what is in them, and what they leave of the frame around them. Rays through one: brush_models_test.cpp.

#include "tests/effect_frames/effect_stage.h"
#include "tools/gallery/mesh_scene.h"

namespace oblong::test::mirror_test {
namespace {

/// A room with a mirror on its far wall, and a light.
MapText mirror_room(const std::string& entities = "") {
    return room_with("",
                     entity("func_wall", {}, box({248, -100, 30}, {254, 100, 160}, "mirror")) +
                         entity_at("light", {0, 0, 120}) + entities,
                     "other");
}

Camera toward_mirror() {
    return camera_at(point_at(-100, 3, 90), 0);
}

TEST(Mirrors, ShowWhatIsBehindTheEye) {
    const std::string lamp = entities_of("misc_sprite -200 30 90 texture={lamp scale=2");
    EffectStage stage(mirror_room(lamp), toward_mirror());
    const Picture with = stage.draw();
    EXPECT_TRUE(stage.has("mirror"));
    const std::int64_t owned = stage.pixels(Effect::Mirror);
    EXPECT_TRUE(stage.has(Effect::Sprites));
    EXPECT_GE(stage.pixels(Effect::Sprites), count_of(with, kLamp));
    const auto [left, right] = counts_by_side(with, kLamp);
    EXPECT_GT(left, 50) << "on the side of +y, as a mirror shows it";
    EXPECT_GT(left, right);
    const Picture without = stage.draw_without(Effect::Mirror);
    EXPECT_FALSE(stage.has("mirror"));
    EXPECT_EQ(count_of(without, kLamp), 0);
    EXPECT_LE(changed_pixels(with, without), owned);
    EXPECT_EQ(count_of(without, kMirror), owned) << "a wall";
}

TEST(Mirrors, ShowMeshesBeforeThemAndNoneBehind) {
    constexpr std::uint8_t kBall = 220;
    const Mesh ball = ball_mesh(30, 8, plain_skin(kBall));
    PlacedMesh placed;
    placed.mesh = &ball;
    placed.least_light = 256;
    EffectStage stage(mirror_room(), toward_mirror());
    const Picture bare = stage.draw();
    placed.position = point_at(-200, 30, 90);
    stage.meshes = {placed};
    const Picture with = stage.draw();
    EXPECT_TRUE(stage.has(Effect::Meshes));
    EXPECT_EQ(stage.pixels(Effect::Meshes), count_of(with, kBall));
    const auto [left, right] = counts_by_side(with, kBall);
    EXPECT_GT(left, 50) << "on the side of +y, as a mirror shows it";
    EXPECT_GT(left, right);
    stage.meshes[0].position = point_at(300, 0, 90);
    EXPECT_EQ(stage.draw(), bare);
}

TEST(Mirrors, ShowNoSpriteAndNoParticleBehindThem) {
    const auto drawn = [](const std::string& behind) {
        const std::string mirror = entity("func_wall", {}, box({100, -100, 30}, {104, 100, 160}, "mirror"));
        return EffectStage(room_with("", mirror + entity_at("light", {0, 0, 120}) + behind, "other"), toward_mirror())
            .draw();
    };
    const Whole at{140, 0, 90};
    EXPECT_EQ(drawn(entity_at("misc_sprite", at, {{"texture", "{lamp"}})), drawn(""));
    EXPECT_EQ(drawn(entity_at("misc_rain", at, {{"size", "16 16 80"}, {"count", "200"}})), drawn(""));
}

/// A pit behind the eye, whose low fog nothing but the mirror shows.
TEST(Mirrors, ShowLowFogBelowAllThatTheFrameItselfShows) {
    MapText text;
    text.brushes = room({-600, -256, -128}, {256, 256, 192}) + box({-120, -256, -128}, {256, 256, 0});
    text.entities = entity("func_wall", {}, box({248, -100, 30}, {254, 100, 160}, "mirror"));
    text.world_keys = {{"fog", "4 0.784 0.784 0.784 1 0 4096 -4 1"}};
    EffectStage stage(text, toward_mirror());
    const Picture with = stage.draw();
    EXPECT_GT(changed_pixels(with, stage.draw_without(Effect::Fog)), 400);
    stage.draw_without(Effect::Mirror);
    EXPECT_FALSE(stage.has(Effect::Fog));
}

/// Two alcoves behind doorways in the east wall: a mirror round the corner of one, a lamp round that of the other. The
/// lamp is in sight from a mirror in the north wall, and not from the first one.
TEST(Mirrors, ShowWhatIsInSightFromEachOfTwo) {
    const auto alcoves = [](const char* round_the_corner) {
        MapText text =
            room_with("", entity("func_wall", {}, box({120, 250, 30}, {250, 256, 160}, "mirror")) +
                              entity("func_wall", {}, box({490, -118, 30}, {496, -62, 160}, round_the_corner)) +
                              entities_of("misc_sprite 350 70 90 texture={lamp"));
        text.brushes = room({-256, -256, 0}, {496, 256, 192}) + box({256, -256, 0}, {300, -180, 192}) +
                       box({256, -120, 0}, {300, 100, 192}) + box({300, -60, 0}, {496, 40, 192}) +
                       box({256, 200, 0}, {300, 256, 192});
        return text;
    };
    const Camera camera = camera_at(point_at(-200, -230, 90), 30);
    EffectStage both(alcoves("mirror"), camera), one(alcoves("other"), camera);
    const Picture with_both = both.draw(), with_one = one.draw();
    EXPECT_GT(both.pixels(Effect::Mirror), one.pixels(Effect::Mirror));
    std::int64_t lamp = 0;
    for (std::size_t i = 0; i < with_both.size(); ++i) {
        if (one.texture_at(i) != "mirror" || with_both[i] == kMirror) continue;  // in a mirror, another is a wall
        ASSERT_EQ(with_both[i], with_one[i]);
        lamp += with_both[i] == kLamp;
    }
    EXPECT_GT(lamp, 20);
}

TEST(Mirrors, BuildNoSurfaceAgainAndCountLightOnce) {
    const std::string lantern = entities_of("misc_lantern 100 0 80 texture={lamp light=300 scale=0.25");
    EffectStage stage(mirror_room(lantern), toward_mirror(), shades_as_colours());
    const Picture first = stage.draw(1'000);
    EXPECT_GT(stage.work.counts.stages.lit_texels, 0);
    EXPECT_TRUE(stage.has(Effect::Lights));
    EXPECT_LE(stage.pixels(Effect::Lights), kPicturePixels);
    EXPECT_EQ(stage.draw(1'000), first);
    EXPECT_EQ(stage.work.counts.stages.lit_texels, 0) << "nothing has moved";
    stage.draw(2'000);
    EXPECT_GT(stage.work.counts.stages.lit_texels, 0);
    EXPECT_EQ(stage.draw(1'000), first);
}

/// A light behind the eye, which only the picture of a mirror ahead calls for, and one beside the eye, which that of a
/// mirror at the other side does not. All show the floor, a single face, which the light touches.
TEST(Mirrors, WithLightsOnOneSideOnlyBuildNoSurfaceAgain) {
    const std::string ahead = box({248, -100, 30}, {254, 100, 160}, "mirror"),
                      aside = box({100, 248, 4}, {250, 254, 160}, "mirror");
    for (const auto& [mirror, place, radius] :
         {std::tuple{ahead, Whole{-230, 200, 30}, "50"}, {aside, Whole{0, -60, 30}, "60"}}) {
        const std::string lantern =
            entity_at("misc_lantern", place, {{"texture", "{lamp"}, {"light", radius}, {"radius", "0"}});
        MapText text =
            room_with("", entity("func_wall", {}, mirror) + entity_at("light", {0, 0, 120}) + lantern, "other");
        text.brushes = replaced(text.brushes, " 0 0 0 1 1", " 0 0 0 4 4");
        EffectStage stage(text, toward_mirror(), shades_as_colours());
        const Picture first = stage.draw();
        EXPECT_TRUE(stage.has("mirror"));
        EXPECT_EQ(stage.draw(), first);
        EXPECT_EQ(stage.work.counts.stages.lit_texels, 0);
        EXPECT_EQ(stage.draw_afresh(), first);
        EXPECT_NE(stage.draw_without(Effect::Lights), first);
    }
}

}  // namespace
}  // namespace oblong::test::mirror_test

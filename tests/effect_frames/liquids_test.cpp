// Liquids: they move and return, cover what is under them by a share, and wave the picture of who is in them.

#include <algorithm>
#include <array>
#include <set>

#include "engine/effects/warp.h"
#include "engine/level/level.h"
#include "tests/effect_frames/effect_stage.h"

namespace oblong::test {
namespace {

constexpr std::int64_t kHuge_ms = std::int64_t{1} << 32;

/// The first whole number of periods at 2^32 ms or later.
constexpr std::int64_t periods_past_huge(std::int64_t period_ms) {
    return (kHuge_ms + period_ms - 1) / period_ms * period_ms;
}

/// A room whose floor is under 32 units of a liquid.
MapText pool(const std::string& liquid, const std::vector<std::array<std::string, 2>>& world_keys = {}) {
    MapText text = room_with(liquid.empty() ? "" : box({-256, -256, 0}, {256, 256, 32}, liquid), "", "floor");
    text.world_keys = world_keys;
    return text;
}

Camera above() {
    return camera_at(point_at(-200, 3, 120), 0, 30);
}

TEST(Liquids, MoveOnTheirOwnPixelsAndRepeat) {
    EffectStage stage(pool("*water"), above());
    const Picture start = stage.draw(0);
    EXPECT_GT(stage.pixels(Effect::Liquid), 10'000);
    EXPECT_EQ(stage.pixels("liquid"), stage.pixels(Effect::Liquid));
    for (const std::int64_t time_ms : {std::int64_t{100}, std::int64_t{1'600}, std::int64_t{4'711}}) {
        const Picture later = stage.draw(time_ms);
        EXPECT_GT(changed_pixels(later, start), 500) << time_ms;
        EXPECT_TRUE(differ_on(stage, "*water", later, start)) << time_ms;
        EXPECT_EQ(stage.draw(time_ms + kWarpPeriod_ms), later);
        EXPECT_EQ(stage.draw(time_ms + periods_past_huge(kWarpPeriod_ms)), later);
        EXPECT_EQ(stage.draw(time_ms + (kHuge_ms << 20) / kWarpPeriod_ms * kWarpPeriod_ms), later);
    }
}

TEST(Liquids, NotAllowedAreOneColourInPlace) {
    EffectStage stage(pool("*water"), above());
    const Picture with = stage.draw();
    const std::int64_t owned = stage.pixels(Effect::Liquid);
    const Picture without = stage.draw_without(Effect::Liquid);
    EXPECT_FALSE(stage.has("liquid"));
    EXPECT_FALSE(stage.has(Effect::Liquid));
    EXPECT_EQ(stage.pixels("flat"), owned);
    std::set<std::uint8_t> colours;
    for (std::size_t i = 0; i < with.size(); ++i)
        if (stage.texture_at(i) == "*water") colours.insert(without[i]);
    EXPECT_TRUE(differ_on(stage, "*water", with, without));
    EXPECT_EQ(colours.size(), 1u);
}

/// Half of one grey over another is the grey between: of a half, the brighter one.
TEST(Translucency, IsThatShareOfWhatIsBehind) {
    const Picture behind = EffectStage(pool(""), above()).draw();
    for (const auto& [alpha, share_256] : {std::pair("0.25", 64), std::pair("0.5", 128), std::pair("0.75", 192)}) {
        EffectStage stage(pool("*slime", {{"slimealpha", alpha}}), above());
        const Picture picture = stage.draw();
        EXPECT_TRUE(stage.has(Effect::Translucency));
        std::int64_t mixed = 0;
        for (std::size_t i = 0; i < picture.size(); ++i) {
            const int mixture = (kSlime * share_256 + behind[i] * (256 - share_256) + 128) / 256;
            mixed += picture[i] == mixture;
            ASSERT_TRUE(picture[i] == mixture || picture[i] == behind[i]) << int{picture[i]};
        }
        EXPECT_EQ(mixed, stage.pixels(Effect::Translucency));
        EXPECT_GT(mixed, 10'000);
    }
}

/// The level as compilers make it that take liquids for opaque: no leaf sees leaves that other contents fill.
Level with_opaque_liquids(Level level) {
    level.visibility.clear();
    for (const LeafIndex from : level.visible_leaves()) {
        level.leaves[from].visibility_offset = static_cast<std::int32_t>(level.visibility.size());
        std::vector<std::uint8_t> row(visible_set_size(level));
        for (const LeafIndex to : level.visible_leaves())
            if (level.leaves[to].contents == level.leaves[from].contents)
                row[(to.position() - 1) / 8] |= static_cast<std::uint8_t>(1 << (to.position() - 1) % 8);
        for (const std::uint8_t bits : row) {
            level.visibility.push_back(bits);
            if (bits == 0) level.visibility.push_back(1);  // so many bytes of 0
        }
    }
    return level;
}

/// What is under the surface is found by the second walk, which comes to the surface again.
TEST(Translucency, OfALiquidThatTheVisibleSetsEndAtIsMixedOnce) {
    const Level level = compile_effects(pool("*slime", {{"slimealpha", "0.5"}}));
    EffectStage known(level, above()), unknown(with_opaque_liquids(level), above());
    EXPECT_EQ(unknown.draw(), known.draw());
    EXPECT_GT(unknown.pixels(Effect::Translucency), 10'000);
}

TEST(Translucency, OfOneIsOpaqueAndOfZeroNothing) {
    EffectStage opaque(pool("*water"), above()), of_one(pool("*water", {{"wateralpha", "1"}}), above()),
        of_zero(pool("*water", {{"wateralpha", "0"}}), above());
    EXPECT_EQ(of_one.draw(777), opaque.draw(777));
    EXPECT_FALSE(of_one.has(Effect::Translucency));
    EXPECT_EQ(of_one.work.plan.passes, opaque.work.plan.passes);
    EXPECT_EQ(of_zero.draw(777), EffectStage(pool(""), above()).draw());
}

/// A pane, a liquid in a box and bars, each of its own opacity, beside each other before a wall.
MapText panes(const std::array<const char*, 3>& alphas) {
    MapText text = room_with("", "", "floor");
    const std::array<const char*, 3> textures{"other", "*slime", "{bars"};
    for (int i = 0; i < 3; ++i)
        text.entities += entity("func_wall", {{"alpha", alphas[i]}},
                                box({-40, 40 - 60 * i, 40}, {-36, 90 - 60 * i, 140}, textures[i]));
    return text;
}

TEST(Translucency, OfABrushEntityIsItsOwn) {
    const Camera eye = camera_at(point_at(-200, 3, 90), 0, 0);
    EffectStage opaque(panes({"1", "0", ""}), eye), half(panes({"0.25", "0.5", "0.75"}), eye);
    const Picture solid = opaque.draw(), mixed = half.draw();
    EXPECT_FALSE(opaque.has(Effect::Translucency)) << "0 is as in other engines the same as none";
    const Picture behind = half.draw_without(Effect::BrushModels);
    std::array<int, 3> seen{};
    for (std::size_t i = 0; i < mixed.size(); ++i) {
        const std::array colours{kOther, kSlime, kBars};
        const auto pane = static_cast<std::size_t>(std::ranges::find(colours, solid[i]) - colours.begin());
        const int share_256 = pane < 3 ? 64 * (static_cast<int>(pane) + 1) : 0;
        ASSERT_EQ(mixed[i], (solid[i] * share_256 + behind[i] * (256 - share_256) + 128) / 256) << i;
        if (pane < 3) ++seen[pane];
    }
    for (const int count : seen) EXPECT_GT(count, 1'000);
    EXPECT_EQ(half.draw_without(Effect::Translucency), solid);
}

TEST(Translucency, NotAllowedIsOpaque) {
    EffectStage opaque(pool("*water"), above()), half(pool("*water", {{"wateralpha", "0.5"}}), above());
    EXPECT_EQ(half.draw_without(Effect::Translucency, 777), opaque.draw(777));
    EXPECT_FALSE(half.has("see_through"));
    EXPECT_EQ(half.pixels(Effect::Liquid), opaque.pixels(Effect::Liquid));
}

TEST(Underwater, OnlyWhereTheEyeIsInALiquid) {
    EffectStage stage(pool("*water"), camera_at(point_at(-200, 3, 33), 0, 10));
    stage.draw();
    EXPECT_FALSE(stage.has("underwater"));
    EXPECT_EQ(stage.pixels(Effect::Underwater), 0);
    stage.camera.eye = point_at(-200, 3, 31);
    const Picture start = stage.draw();
    EXPECT_TRUE(stage.has("underwater"));
    EXPECT_EQ(stage.pixels(Effect::Underwater), kPicturePixels);
    EXPECT_NE(stage.draw(1'000), start);
    EXPECT_EQ(stage.draw(kUnderwaterPeriod_ms * kWarpPeriod_ms), start);
    EXPECT_NE(stage.draw_without(Effect::Underwater), start);
    EXPECT_FALSE(stage.has("underwater"));
}

/// As in Quake, where sky is infinitely far away. It fills the view, so that no leaf behind it is entered.
TEST(Sky, IsBehindThingsThatAreFarther) {
    const std::string lamp = entity_at("misc_sprite", {200, 0, 90}, {{"texture", "{lamp"}, {"scale", "2"}});
    EffectStage stage(room_with(box({100, -256, 0}, {116, 256, 176}, "sky"), lamp), camera_at(point_at(60, 3, 90), 0));
    const Picture picture = stage.draw();
    EXPECT_EQ(stage.pixels("sky"), kPicturePixels);
    EXPECT_GT(count_of(picture, kLamp), 50);
}

TEST(Sky, DriftsOnItsOwnPixelsAndRepeats) {
    MapText text;
    text.brushes = box({-272, -272, -16}, {272, 272, 0}) + box({-272, -272, 192}, {272, 272, 208}, "sky") +
                   box({-272, -272, 0}, {-256, 272, 192}) + box({256, -272, 0}, {272, 272, 192}) +
                   box({-256, -272, 0}, {256, -256, 192}) + box({-256, 256, 0}, {256, 272, 192});
    EffectStage stage(text, camera_at(point_at(-200, 3, 100), 0, -20));
    const Picture start = stage.draw(0), later = stage.draw(1'500);
    EXPECT_GT(stage.pixels("sky"), 5'000);
    EXPECT_GT(changed_pixels(start, later), 200);
    EXPECT_TRUE(differ_on(stage, "sky", later, start));
    EXPECT_EQ(stage.draw(1'500 + 16'000), later);
    EXPECT_EQ(stage.draw(1'500 + periods_past_huge(16'000)), later);
    const Picture flat = stage.draw_without(Effect::Sky);
    EXPECT_FALSE(stage.has("sky"));
    EXPECT_TRUE(differ_on(stage, "sky", flat, start));
}

}  // namespace
}  // namespace oblong::test

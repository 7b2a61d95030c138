#include "engine/scene/level_effects.h"

#include <gtest/gtest.h>

#include "engine/io/doubles.h"
#include "tests/scene/scene_fixture.h"

namespace oblong::test {
namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

LevelEffects effects_of_world(Pairs pairs) {
    Level level = tiny_level();
    pairs.insert(pairs.begin(), {"classname", "worldspawn"});
    level.entities = {Entity{pairs}};
    return read_level_effects(level);
}

LevelEffects effects_of_key(const std::string& key, const std::string& value) {
    return effects_of_world({{key, value}});
}

TEST(LevelEffects, APlainLevelCallsForNothing) {
    const LevelEffects effects = effects_of_world({});
    EXPECT_FALSE(effects.fog);
    EXPECT_EQ(effects.liquid_alpha_256, (std::array<std::uint16_t, 4>{256, 256, 256, 256}));
    EXPECT_TRUE(effects.palette_cycles.empty());
    EXPECT_TRUE(effects.light_patterns.entries.empty());
    EXPECT_TRUE(effects.animations.is_empty());
    EXPECT_TRUE(effects.warnings.empty());
}

TEST(LevelEffects, FogOfFitzQuake) {
    const auto fog = effects_of_key("fog", " 0.035 1\t.5 0 ").fog;
    ASSERT_TRUE(fog);
    EXPECT_NEAR(number_of(fog->density), 0.035, 1e-7);
    EXPECT_EQ(fog->colour, (Rgb8{255, 128, 0}));
    EXPECT_EQ(fog->alpha_256, 256);
    EXPECT_EQ(fog->nearest, World{});
    EXPECT_EQ(fog->farthest, World::highest());
    EXPECT_FALSE(fog->has_top);
}

TEST(LevelEffects, FogOfDarkPlaces) {
    const auto fog = effects_of_key("fog", "2 0 0 0 0.5 16 1024.25 -96.5 64").fog;
    ASSERT_TRUE(fog);
    EXPECT_EQ(fog->alpha_256, 128);
    EXPECT_EQ(number_of(fog->nearest), 16);
    EXPECT_EQ(number_of(fog->farthest), 1024.25);
    EXPECT_TRUE(fog->has_top);
    EXPECT_EQ(number_of(fog->top), -96.5);
    EXPECT_EQ(number_of(fog->fade_depth), 64);
    EXPECT_FALSE(effects_of_key("fog", "2 0 0 0 1 0 100").fog->has_top) << "the last numbers may be left out";
}

TEST(LevelEffects, NoFogIsNoFault) {
    for (const char* nothing : {"0 1 1 1", "0.5 1 1 1 0"}) {
        EXPECT_FALSE(effects_of_key("fog", nothing).fog);
        EXPECT_TRUE(effects_of_key("fog", nothing).warnings.empty());
    }
}

TEST(LevelEffects, FogThatCannotBeReadIsReportedAndOff) {
    for (const char* value : {"",
                              "0.5",
                              "0.5 1 1",
                              "nan 1 1 1",
                              "inf 1 1 1",
                              "1e3 1 1 1",
                              "-0.1 1 1 1",
                              "65 1 1 1",
                              "0.1 1 1 1.01",
                              "0.1 1 -1 1",
                              "0.1 1 1 1 2",
                              "0.1 1 1 1 1 500 100",
                              "0.1 1 1 1 1 5 5",
                              "0.1 1 1 1 1 -5 5",
                              "0.1 1 1 1 1 0 262145",
                              "0.1 1 1 1 1 0 100 0 0",
                              "0.1 1 1 1 1 0 100 0 -5",
                              "0.1 1 1 1 1 0 100 2147483647",
                              "0.1 1 1 1 1 0 100 0 5 6",
                              "0.1 1 1 red",
                              "99999999999999999999 1 1 1",
                              "0.1,1,1,1"}) {
        const LevelEffects effects = effects_of_key("fog", value);
        EXPECT_FALSE(effects.fog) << value;
        ASSERT_EQ(effects.warnings.size(), 1u) << value;
        EXPECT_TRUE(effects.warnings[0].starts_with("worldspawn key 'fog': '" + std::string(value).substr(0, 60)))
            << effects.warnings[0];
        EXPECT_NE(effects.warnings[0].find("expected density r g b"), std::string::npos);
    }
}

TEST(LevelEffects, LiquidsHaveAnAlphaOfTheirKind) {
    const LevelEffects effects = effects_of_world({{"wateralpha", "0.5"}, {"_telealpha", "0"}, {"lavaalpha", "1"}});
    EXPECT_EQ(effects.liquid_alpha_256, (std::array<std::uint16_t, 4>{128, 256, 256, 0}));
    EXPECT_TRUE(effects.warnings.empty());
    for (const char* value : {"", "1.01", "-0.5", "nan", "half", "0.5 0.5", "256"}) {
        const LevelEffects wrong = effects_of_key("slimealpha", value);
        EXPECT_EQ(wrong.liquid_alpha_256[1], 256) << value;
        ASSERT_EQ(wrong.warnings.size(), 1u);
        EXPECT_EQ(wrong.warnings[0],
                  "worldspawn key 'slimealpha': '" + std::string(value) + "', expected an alpha from 0 to 1");
    }
}

TEST(LevelEffects, LiquidKindsByTextureName) {
    EXPECT_EQ(liquid_kind_of_texture("*lava1"), LiquidKind::Lava);
    EXPECT_EQ(liquid_kind_of_texture("*04slime2"), LiquidKind::Slime);
    EXPECT_EQ(liquid_kind_of_texture("*teleport"), LiquidKind::Teleporter);
    EXPECT_EQ(liquid_kind_of_texture("*04water1"), LiquidKind::Water);
    EXPECT_EQ(liquid_kind_of_texture("*"), LiquidKind::Water) << "all others";
}

TEST(LevelEffects, PaletteCyclesInTheirOrder) {
    const LevelEffects effects = effects_of_world({{"palette_cycle2", "16 31 -8"}, {"palette_cycle", "224 239 0.5"}});
    ASSERT_EQ(effects.palette_cycles.size(), 2u);
    EXPECT_EQ(effects.palette_cycles[0].first, 16);
    EXPECT_EQ(effects.palette_cycles[0].last, 31);
    EXPECT_EQ(number_of(effects.palette_cycles[0].steps_per_second), -8);
    EXPECT_EQ(number_of(effects.palette_cycles[1].steps_per_second), 0.5);
    for (const char* value : {"", "1 2", "1 2 3 4", "5 5 1", "6 5 1", "-1 5 1", "0 256 1", "0.5 5 1", "0 5.5 1",
                              "0 5 0", "0 5 -1001", "0 5 1001", "a b c"}) {
        const LevelEffects wrong = effects_of_key("palette_cycle", value);
        EXPECT_TRUE(wrong.palette_cycles.empty()) << value;
        EXPECT_EQ(wrong.warnings.size(), 1u) << value;
    }
}

TEST(LevelEffects, TooManyPaletteCyclesAreReported) {
    Pairs pairs;
    for (int i = 1; i <= 18; ++i) pairs.push_back({"palette_cycle" + std::to_string(i), "0 5 1"});
    const LevelEffects effects = effects_of_world(pairs);
    EXPECT_EQ(effects.palette_cycles.size(), 16u);
    EXPECT_EQ(effects.warnings.size(), 2u);
}

TEST(LevelEffects, UnknownKeysAreReportedOnce) {
    const LevelEffects effects = effects_of_world({{"fogg", "1"},
                                                   {"message", "hi"},
                                                   {"_tb_def", "x"},
                                                   {"_sunlight", "200"},
                                                   {"fogg", "2"},
                                                   {"palette_cycles", "0 5 1"},
                                                   {"sky", "night"},
                                                   {"x\n\x1b[31m", ""}});
    EXPECT_EQ(effects.warnings,
              (std::vector<std::string>{
                  "worldspawn key 'fogg' is unknown", "worldspawn key 'palette_cycles' is unknown",
                  "worldspawn key 'sky': a sky is a texture of two layers; there are no boxes of six pictures",
                  "worldspawn key 'x??[31m' is unknown"}));
}

TEST(LevelEffects, WarningsAreFewAndShort) {
    Pairs pairs;
    for (int i = 0; i < 5000; ++i) pairs.push_back({"key" + std::to_string(i) + std::string(2000, 'x'), ""});
    const LevelEffects effects = effects_of_world(pairs);
    EXPECT_EQ(effects.warnings.size(), 65u);
    EXPECT_EQ(effects.warnings.back(), "4936 more warnings");
    for (const std::string& warning : effects.warnings) EXPECT_LT(warning.size(), 200u);
}

TEST(LevelEffects, KeysOfOtherEntitiesAreTheirs) {
    Level level = tiny_level();
    level.entities = {Entity{{{"classname", "light"}, {"fog", "bad"}, {"foo", "bar"}}}};
    EXPECT_TRUE(read_level_effects(level).warnings.empty()) << "and there may be no worldspawn";
}

LevelEffects effects_of_lights(const std::vector<Pairs>& lights) {
    Level level = tiny_level();
    level.faces[FaceIndex(0)].styles = {32, 33, 255, 255};
    for (Pairs pairs : lights) {
        pairs.insert(pairs.begin(), {"classname", "light_torch"});
        level.entities.push_back(Entity{pairs});
    }
    return read_level_effects(level);
}

TEST(LevelEffects, LightsGiveTheirStyleAPattern) {
    const LevelEffects effects = effects_of_lights({{{"style", "32"}, {"pattern", "az"}}, {{"style", "33"}}});
    EXPECT_TRUE(effects.warnings.empty());
    ASSERT_EQ(effects.light_patterns.entries.size(), 1u);
    EXPECT_EQ(light_styles_at(effects.light_patterns, 0, Flashes::Full)[32], 0);
}

TEST(LevelEffects, PatternsThatCannotBeAreReported) {
    for (const Pairs& wrong : {Pairs{{"style", "32"}, {"pattern", "AZ"}},
                               {{"style", "31"}, {"pattern", "az"}},
                               {{"style", "64"}, {"pattern", "az"}},
                               {{"style", "4294967328"}, {"pattern", "az"}},
                               {{"style", "-32"}, {"pattern", "az"}},
                               {{"pattern", "az"}},
                               {{"style", "32"}, {"pattern", std::string(70'000, 'a')}}}) {
        const LevelEffects effects = effects_of_lights({wrong});
        EXPECT_TRUE(effects.light_patterns.entries.empty()) << wrong[0].second;
        ASSERT_EQ(effects.warnings.size(), 1u) << wrong[0].second;
        EXPECT_LT(effects.warnings[0].size(), 200u);
    }
}

TEST(LevelEffects, OneStyleHasOnePattern) {
    const Pairs first{{"style", "32"}, {"pattern", "az"}}, second{{"style", "32"}, {"pattern", "zz"}};
    EXPECT_TRUE(effects_of_lights({first, first}).warnings.empty());
    const LevelEffects effects = effects_of_lights({first, second});
    ASSERT_EQ(effects.warnings.size(), 1u);
    EXPECT_EQ(effects.warnings[0], "light with the pattern 'zz': style 32 has the pattern 'az' already, expected one");
    EXPECT_EQ(light_styles_at(effects.light_patterns, 0, Flashes::Full)[32], 0) << "the first stands";
}

TEST(LevelEffects, WarningsOfTexturesAreAmongThem) {
    Level level = tiny_level();
    add_texture(level, "+0x");
    add_texture(level, "+2x");
    EXPECT_EQ(read_level_effects(level).warnings.size(), 1u);
}

}  // namespace
}  // namespace oblong::test

#include "tools/map/source/checks.h"

#include <gtest/gtest.h>

#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

// What is said of a sealed room with these entities and a start, "line N: WHAT" each.
std::vector<std::string> warnings_of(const std::string& entities) {
    const std::string text = entities + entity_at("info_player_start", {64, 64, 40});
    std::vector<std::string> said;
    for (const map::Warning& warning :
         map::find_warnings(map::parse_map("{\n\"classname\" \"worldspawn\"\n}\n" + text)))
        said.push_back("line " + std::to_string(warning.line) + ": " + warning.what);
    return said;
}

using Said = std::vector<std::string>;

TEST(Checks, AreSilentAboutWhatQuakeKnows) {
    EXPECT_EQ(warnings_of(entity_at("light_flame_large_yellow", {1, 2, 3}, {{"light", "200"}, {"style", "4"}}) +
                          entity("func_door", {{"lip", "8"}, {"dmg", "2"}, {"_tb_group", "3"}}) +
                          entity_at("monster_shambler", {1, 2, 3}, {{"spawnflags", "1"}})),
              Said{});
}

TEST(Checks, NameUnknownClassesAndKeysByTheirLines) {
    EXPECT_EQ(warnings_of(entity("fnuc_door", {{"angle", "90"}}) + entity("func_door", {{"wiat", "3"}})),
              (Said{"line 4: the class 'fnuc_door' is unknown: the entity is written as it stands",
                    "line 10: the key 'wiat' is unknown"}));
    EXPECT_EQ(warnings_of("{\n\"origin\" \"1 2 3\"\n}\n"), Said{"line 4: an entity without a classname, expected one"});
}

TEST(Checks, CountWhatIsSaidAgain) {
    const std::string lamp = entity_at("light", {1, 2, 3}, {{"_color", "1 0 0"}});
    EXPECT_EQ(warnings_of(lamp + lamp + lamp), Said{"line 6: the key '_color' has no effect here (so 2 more)"});
    EXPECT_EQ(warnings_of(entity("func_wall", {{"_shadow", "1"}})),
              Said{"line 6: the key '_shadow' has no effect here"});
}

TEST(Checks, NameValuesThatAreTakenInAnotherWay) {
    EXPECT_EQ(warnings_of(entity("light", {{"_light", "255 128 0 400"}})),
              Said{"line 6: the colour in '_light' is not kept, only its brightness"});
    EXPECT_EQ(warnings_of(entity("light", {{"delay", "4"}})),
              Said{"line 6: 'delay' is '4', expected 0, 1, 2, 3 or 5: 0 is taken"});
    EXPECT_EQ(warnings_of(entity("light", {{"delay", "5"}})), Said{});
    EXPECT_EQ(warnings_of(entity("light", {{"wait", "1 2"}})),
              Said{"line 6: 'wait' is '1 2', expected one number: the first is taken"});
}

TEST(Checks, KnowEffects) {
    EXPECT_EQ(warnings_of(entity_at("misc_rain", {1, 2, 3}, {{"size", "64 64 64"}, {"count", "200"}}) +
                          entity_at("misc_sprite", {1, 2, 3}, {{"texture", "{tree"}, {"shadow", "24"}}) +
                          entity("func_detail_fence", {{"palette_cycle", "240 243 4"}, {"fog", "0.5 1 1 1"}})),
              Said{});
    EXPECT_EQ(warnings_of(entity("misc_dust", {{"size", "64"}})), Said{"line 6: 'size' is '64', expected 3 numbers"});
    EXPECT_EQ(warnings_of(entity("func_wall", {{"palette_cycle2", "240 243"}, {"palette_cycles", "1 2 3"}})),
              (Said{"line 6: 'palette_cycle2' is '240 243', expected first, last, steps a second",
                    "line 7: the key 'palette_cycles' is unknown"}));
    EXPECT_EQ(warnings_of(entity("misc_lantern", {{"texture", "lamp"}})),
              Said{"line 4: the texture of a misc_lantern is 'lamp', expected one that begins with '{'"});
}

TEST(Checks, MissTheStart) {
    const auto warnings = map::find_warnings(map::parse_map("// a remark\n{\n\"classname\" \"worldspawn\"\n}\n"));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].line, 2);
    EXPECT_EQ(warnings[0].what, "no info_player_start: nobody can play the level");
}

}  // namespace
}  // namespace oblong::test

#include "tools/map/source/checks.h"

#include <gtest/gtest.h>

#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

// What is said of a source, "line N: WHAT" each.
std::vector<std::string> warnings_of_source(const std::string& source) {
    map::Warnings warnings;
    map::find_warnings(map::parse_map(source), warnings);
    std::vector<std::string> said;
    for (const map::Warning& warning : warnings.take())
        said.push_back("line " + std::to_string(warning.line) + ": " + warning.what);
    return said;
}

// Of a world with these entities, from line 4 on, and a start.
std::vector<std::string> warnings_of(const std::string& entities) {
    return warnings_of_source("{\n\"classname\" \"worldspawn\"\n}\n" + entities +
                              entity_at("info_player_start", {64, 64, 40}));
}

using Said = std::vector<std::string>;

const std::string kBrush = box({0, 0, 0}, {8, 8, 8});

TEST(Warnings, CountOnlyWhatCameSinceTheyWereTaken) {
    map::Warnings warnings;
    warnings.add(3, "it");
    warnings.add(5, "it");
    EXPECT_EQ(warnings.take().at(0).what, "it (and 1 more like this)");
    warnings.add(7, "it");
    const auto later = warnings.take();
    ASSERT_EQ(later.size(), 1u);
    EXPECT_EQ(later[0].line, 7);
    EXPECT_EQ(later[0].what, "it");
}

TEST(Checks, AreSilentAboutWhatQuakeKnows) {
    EXPECT_EQ(warnings_of(entity_at("light_flame_large_yellow", {1, 2, 3}, {{"light", "200"}, {"style", "4"}}) +
                          entity("func_door", {{"lip", "8"}, {"dmg", "2"}, {"_tb_group", "3"}}, kBrush) +
                          entity_at("monster_shambler", {1, 2, 3}, {{"spawnflags", "1"}}) +
                          entity_at("item_key1", {1, 2, 3}, {{"sounds", "1"}}) +
                          entity("func_button", {{"target", "lightning"}}, kBrush) + entity("event_lightning", {})),
              Said{});
}

TEST(Checks, NameUnknownClassesAndKeysByTheirLines) {
    EXPECT_EQ(warnings_of(entity("fnuc_door", {{"angle", "90"}}) + entity("func_door", {{"wiat", "3"}}, kBrush)),
              (Said{"line 4: the class 'fnuc_door' is unknown, perhaps 'func_door' is meant: the entity is kept "
                    "unchanged",
                    "line 10: nothing reads the key 'wiat' of a func_door, perhaps 'wait' is meant"}));
    EXPECT_EQ(warnings_of(entity("func_explobox", {}) + entity("func_door", {{"wait", "x"}}, kBrush)).at(1),
              "line 4: the class 'func_explobox' is unknown: the entity is kept unchanged")
        << "after what is wrong with what is read";
    EXPECT_EQ(warnings_of(entity_at("light", {1, 2, 3}, {{"targetnmae", "x"}})),
              Said{"line 6: nothing reads the key 'targetnmae' of a light, perhaps 'targetname' is meant"});
    EXPECT_EQ(warnings_of(entity("func_explobox", {{"angle", "90"}})),
              Said{"line 4: the class 'func_explobox' is unknown: the entity is kept unchanged"});
    EXPECT_EQ(warnings_of(entity_at("monster_knigth", {1, 2, 3})),
              Said{"line 4: the class 'monster_knigth' is unknown, perhaps 'monster_knight' is meant: the entity is "
                   "kept unchanged"});
    EXPECT_EQ(warnings_of(entity_at("light", {1, 2, 3}, {{"_project_texture", "x"}})),
              Said{"line 6: nothing reads the key '_project_texture' of a light: lamps shine evenly: no pictures are "
                   "projected"});
    EXPECT_EQ(warnings_of(entity("func_bobbing", {{"angle", "90"}}, kBrush)),
              Said{"line 4: the class 'func_bobbing' is left out (things go from path_corner to path_corner: a "
                   "`func_train`): the entity is kept unchanged"});
    EXPECT_EQ(warnings_of(entity("func_wall", {{"_shadowself", "0"}}, kBrush)), Said{}) << "it asks for nothing";
    EXPECT_EQ(warnings_of("{\n\"origin\" \"1 2 3\"\n}\n"), Said{"line 4: an entity without a classname, expected one"});
}

TEST(Checks, KnowThatPassableDetailIsAModel) {
    EXPECT_EQ(warnings_of(entity("func_detail_illusionary", {{"_minlight", "50"}}, kBrush)), Said{});
}

TEST(Checks, NameKeysThatNothingReads) {
    EXPECT_EQ(warnings_of(entity_at("misc_sprite", {1, 2, 3}, {{"texture", "{tree"}, {"angle", "90"}}) +
                          entity("func_detail", {{"angle", "-1"}}, kBrush)),
              Said{})
        << "editors give an angle to everything";
    EXPECT_EQ(warnings_of(entity("func_wall", {{"lip", "8"}}, kBrush)),
              Said{"line 6: nothing reads the key 'lip' of a func_wall"});
    EXPECT_EQ(warnings_of(entity_at("misc_rain", {1, 2, 3}, {{"fog", "1 1 1 1"}})),
              Said{"line 6: nothing reads the key 'fog' of a misc_rain"});
    const std::string lamp = entity_at("light", {1, 2, 3}, {{"_colour", "1 0 0"}});
    EXPECT_EQ(
        warnings_of(lamp + lamp + lamp),
        Said{"line 6: nothing reads the key '_colour' of a light, perhaps '_color' is meant (and 2 more like this)"});
}

TEST(Checks, NameValuesOfAnotherKind) {
    const auto of_light = [](const std::string& key, const std::string& value) {
        return warnings_of(entity_at("light", {1, 2, 3}, {{key, value}}));
    };
    EXPECT_EQ(of_light("_light", "255 128 0 400"), Said{});
    EXPECT_EQ(of_light("delay", "4"), Said{"line 6: 'delay' is '4', expected 0, 1, 2, 3 or 5: 0 is taken"});
    EXPECT_EQ(of_light("delay", ""), Said{"line 6: 'delay' is '', expected 0, 1, 2, 3 or 5: 0 is taken"});
    for (const char* delay : {"5", "5.0", "05", "2e0"}) EXPECT_EQ(of_light("delay", delay), Said{}) << delay;
    EXPECT_EQ(of_light("style", "64"), Said{"line 6: 'style' is '64', expected a whole number from 0 to 63"});
    EXPECT_EQ(of_light("target", ""), Said{}) << "names nothing";
    EXPECT_EQ(warnings_of(entity("func_fnord", {{"light", "w"}})).size(), 2u) << "any class may shine";
    EXPECT_EQ(of_light("wait", "1 2"), Said{"line 6: 'wait' is '1 2', expected a number"});
    EXPECT_EQ(of_light("style", "candle"), Said{"line 6: 'style' is 'candle', expected a whole number from 0 to 63"});
    EXPECT_EQ(of_light("mangle", "up"), Said{"line 6: 'mangle' is 'up', expected 2 to 3 numbers"});
    EXPECT_EQ(warnings_of(entity("func_door", {{"speed", "fast"}}, kBrush)),
              Said{"line 6: 'speed' is 'fast', expected a number"});
    EXPECT_EQ(warnings_of(entity_at("misc_model", {1, 2, 3}, {{"model", "a.obj"}, {"up", "x"}})),
              Said{"line 7: 'up' is 'x', expected y or z: y is taken"});
}

TEST(Checks, KnowEffects) {
    EXPECT_EQ(warnings_of(entity_at("misc_rain", {1, 2, 3}, {{"size", "64 64 64"}, {"count", "200"}}) +
                          entity_at("misc_sprite", {1, 2, 3}, {{"texture", "{tree"}, {"shadow", "24"}}) +
                          entity_at("info_checkpoint", {1, 2, 3}, {{"size", "64 64 64"}})),
              Said{});
    EXPECT_EQ(warnings_of(entity_at("misc_dust", {1, 2, 3}, {{"size", "64"}})),
              Said{"line 6: 'size' is '64', expected 3 numbers from 1 to 65536"});
    EXPECT_EQ(warnings_of(entity_at("misc_rain", {1, 2, 3}, {{"count", "131073"}, {"period", "-3"}})),
              (Said{"line 6: 'count' is '131073', expected a number from 0 to 131072",
                    "line 7: 'period' is '-3', expected a number from 0.05 to 3600"}));
    EXPECT_EQ(warnings_of(entity_at("misc_model", {1, 2, 3}, {{"model", "a.obj"}, {"highlight", "256"}})),
              Said{"line 7: 'highlight' is '256', expected a whole number from 0 to 255"});
    EXPECT_EQ(warnings_of(entity_at("misc_lantern", {1, 2, 3}, {{"texture", "lamp"}})),
              Said{"line 6: 'texture' is 'lamp', expected a texture that begins with '{'"});
}

TEST(Checks, KnowTheWorldsKeys) {
    const auto of_world = [](const std::vector<std::array<std::string, 2>>& pairs) {
        return warnings_of_source(entity("worldspawn", pairs) + entity_at("info_player_start", {64, 64, 40}));
    };
    EXPECT_EQ(of_world({{"skyfog", "0.5"},
                        {"fog", "0.5 1 1 1"},
                        {"_wateralpha", "0.5"},
                        {"_phong", "1"},
                        {"_phong_angle", "30"},
                        {"palette_cycle", "240 243 4"},
                        {"palette_cycle12", "240 243 4"}}),
              Said{});
    EXPECT_EQ(
        of_world({{"palette_cycle2", "240 243"}, {"palette_cycles", "1 2 3"}}),
        (Said{"line 3: 'palette_cycle2' is '240 243', expected 3 numbers",
              "line 4: nothing reads the key 'palette_cycles' of a worldspawn, perhaps 'palette_cycle' is meant"}));
    const auto said = of_world({{"fog", "0.5 1 1 1"}, {"skyfog", "2"}, {"_wateralpha", "-1"}, {"fog", "-1 1 1 1"}});
    ASSERT_EQ(said.size(), 4u);
    EXPECT_EQ(said[0], "line 4: worldspawn key 'skyfog': '2', expected a share from 0 to 1");
    EXPECT_EQ(said[1], "line 5: worldspawn key '_wateralpha': '-1', expected an alpha from 0 to 1");
    EXPECT_TRUE(said[2].starts_with("line 6: worldspawn key 'fog': '-1 1 1 1', expected density")) << said[2];
}

TEST(Checks, NameTargetsThatNobodyHas) {
    EXPECT_EQ(warnings_of(entity("func_button", {{"target", "gate"}, {"killtarget", "wall"}}, kBrush) +
                          entity("func_wall", {{"targetname", "wall"}}, kBrush)),
              Said{"line 6: 'target' is 'gate', but no entity has that name"});
}

// A door with a name stays shut until it is activated.
TEST(Checks, NameNamesThatNothingTargets) {
    const std::string door = entity("func_door", {{"targetname", "gate"}}, kBrush);
    EXPECT_EQ(warnings_of(door),
              Said{"line 6: 'targetname' is 'gate', but no entity has that target: nothing activates it"});
    EXPECT_EQ(warnings_of(door + entity("func_button", {{"target", "gate"}}, kBrush)), Said{});
    EXPECT_EQ(warnings_of(door + entity("func_button", {{"killtarget", "gate"}}, kBrush)), Said{});
}

TEST(Checks, NameKeysThatAreSetTwice) {
    EXPECT_EQ(warnings_of(entity("func_door", {{"angle", "90"}, {"lip", "4"}, {"angle", "0"}}, kBrush)),
              Said{"line 8: 'angle' is already set in line 6, expected each key once: that one counts"});
}

TEST(Checks, NameBrushesOfTwoKinds) {
    const auto warnings_of_pool = [](const std::string& top) {
        const std::string pool = box({0, 0, 0}, {8, 8, 8}, "*water");
        const std::size_t last = pool.rfind("*water");
        return warnings_of(entity("func_group", {}, pool.substr(0, last) + top + pool.substr(last + 6)));
    };
    EXPECT_EQ(warnings_of_pool("stone"),
              Said{"line 12: a brush with both '*water' and 'stone' is made of the former, expected textures of one "
                   "kind"});
    EXPECT_EQ(warnings_of_pool("*water2"), Said{});
    EXPECT_EQ(warnings_of_pool("skip"), Said{});
}

TEST(Checks, NameTextureAxesThatDoNotSpanTheirFace) {
    const auto of_floor = [](const std::string& axes) {
        return warnings_of(entity("func_wall", {}, "{\n( 0 0 8 ) ( 0 8 8 ) ( 8 0 8 ) wall " + axes + " 0 1 1\n}\n"));
    };
    EXPECT_EQ(of_floor("[ 1 0 0 0 ] [ 0 -1 0 0 ]"), Said{});
    EXPECT_EQ(of_floor("[ 8 0 99 0 ] [ 1 1 0 0 ]"), Said{}) << "slanted, of any length";
    const std::string zero = "[ 0 0 0 5 ] [ 0 -1 0 0 ]", parallel = "[ 1 2 0 0 ] [ -2 -4 0 0 ]",
                      upright = "[ 1 0 0 0 ] [ 0 0 -1 0 ]";
    for (const std::string& axes : {zero, parallel, upright})
        EXPECT_EQ(of_floor(axes), Said{"line 7: the texture axes of 'wall' are zero, parallel or lead off the face, "
                                       "expected two directions along it"})
            << axes;
}

TEST(Checks, NameTeleportersToNowhere) {
    EXPECT_EQ(warnings_of(entity("trigger_teleport", {}, kBrush)),
              Said{"line 4: a trigger_teleport without 'target', expected the exit, an `info_teleport_destination`"});
    EXPECT_EQ(warnings_of(entity("trigger_teleport", {{"target", "x"}}, kBrush)),
              Said{"line 6: 'target' is 'x', but no entity has that name"});
    EXPECT_EQ(warnings_of(entity("trigger_teleport", {{"target", "x"}}, kBrush) +
                          entity("func_wall", {{"targetname", "x"}}, kBrush)),
              Said{"line 6: 'target' is 'x', but the first entity of that name has no origin"});
}

TEST(Checks, NameWhatAClassNeedsAndAnEntityLacks) {
    EXPECT_EQ(
        warnings_of(entity("func_door", {}) + entity("func_door", {})),
        Said{"line 4: a func_door without brushes, expected at least one: it has no shape (and 1 more like this)"});
    EXPECT_EQ(warnings_of(entity("light", {}, kBrush)),
              Said{"line 4: a light with brushes, expected an 'origin' alone: its class is a point"});
    EXPECT_EQ(warnings_of(entity("info_teleport_destination", {})),
              Said{"line 4: an info_teleport_destination without an 'origin', expected its position"});
    EXPECT_EQ(warnings_of_source(entity("worldspawn", {}) + entity("info_player_start", {})),
              Said{"line 4: an info_player_start without an 'origin', expected its position"});
}

TEST(Checks, MissTheStart) {
    EXPECT_EQ(warnings_of_source("// a remark\n{\n\"classname\" \"worldspawn\"\n}\n"),
              Said{"line 2: no info_player_start, expected one: the player has no place to start"});
}

TEST(Checks, NameASecondStart) {
    EXPECT_EQ(warnings_of(entity_at("info_player_start", {9, 9, 40}) + entity_at("light", {1, 2, 3})),
              Said{"line 12: a second info_player_start, expected one: that of line 4 counts"});
}

// The room for a player is a box of 32 x 32 x 56 units around a place a unit above the start.
TEST(Checks, NameAStartInAWall) {
    const auto said_at = [](const Whole& start) {
        map::Warnings warnings;
        compile(level(room({0, 0, 0}, {128, 128, 128}), entity_at("info_player_start", start)),
                {.is_fast = true, .warnings = &warnings});
        return warnings.take();
    };
    EXPECT_TRUE(said_at({64, 64, 24}).empty()) << "on the floor";
    EXPECT_TRUE(said_at({16, 112, 24}).empty()) << "in a corner";
    for (const Whole& start : {Whole{14, 64, 24}, Whole{64, 64, 20}, Whole{64, 64, 97}}) {
        const auto said = said_at(start);
        ASSERT_EQ(said.size(), 1u) << start[0] << ' ' << start[2];
        EXPECT_TRUE(said[0].what.starts_with("the info_player_start at ")) << said[0].what;
        EXPECT_NE(said[0].what.find(" is in a wall"), std::string::npos) << said[0].what;
    }
}

// A brush in a wall may be a hidden door.
TEST(Checks, NameBrushesOutsideOfTheLevel) {
    const auto said_of = [](const std::string& class_name, const Whole& low, const std::string& name = "") {
        map::Warnings warnings;
        const Whole high{low[0] + 16, low[1] + 16, low[2] + 16};
        compile(level(room({0, 0, 0}, {128, 128, 128}, 32), entity(class_name, {{"targetname", name}}, box(low, high)) +
                                                                entity_at("info_player_start", {64, 64, 24})),
                {.is_fast = true, .warnings = &warnings});
        return warnings.take();
    };
    EXPECT_TRUE(said_of("func_door", {64, 64, 64}).empty());
    EXPECT_TRUE(said_of("func_door", {120, 64, 64}).empty()) << "half in a wall";
    EXPECT_TRUE(said_of("func_door", {136, 64, 64}).empty()) << "in a wall";
    EXPECT_TRUE(said_of("func_train", {400, 64, 64}).empty());
    EXPECT_TRUE(said_of("func_group", {400, 64, 64}).empty()) << "is the world's";
    for (const char* trigger : {"trigger_multiple", "trigger_once", "trigger_teleport", "trigger_changelevel"}) {
        EXPECT_TRUE(said_of(trigger, {400, 64, 64}, "name").empty()) << trigger << ", which others activate";
        EXPECT_EQ(said_of(trigger, {400, 64, 64}).size(), 1u) << trigger;
    }
    for (const char* relay : {"trigger_relay", "trigger_counter"})
        EXPECT_TRUE(said_of(relay, {400, 64, 64}).empty()) << relay << ", which nobody touches";
    EXPECT_EQ(said_of("func_door", {400, 64, 64}, "name").size(), 1u);
    const auto said = said_of("func_door", {400, 64, 64});
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].line, 52);
    EXPECT_TRUE(said[0].what.starts_with("the brushes of func_door are outside of the level")) << said[0].what;
}

TEST(Checks, NameAnOriginBrush) {
    map::Warnings warnings;
    const auto bsp = compile(
        level(room({0, 0, 0}, {128, 128, 128}),
              entity("func_wall", {}, box({32, 32, 32}, {64, 64, 64}) + box({40, 40, 40}, {48, 48, 48}, "origin")) +
                  entity_at("info_player_start", {64, 64, 24})),
        {.is_fast = true, .warnings = &warnings});
    const auto said = warnings.take();
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].what.find("texture 'origin'"), std::string::npos) << said[0].what;
    EXPECT_EQ(bsp.models.at(1).face_count, 6) << "the brush beside it";
}

}  // namespace
}  // namespace oblong::test

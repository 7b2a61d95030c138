#include "tools/map/source/checks.h"

#include <gtest/gtest.h>

#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

using Said = std::vector<std::string>;

// Of a world with these entities, from line 4 on, and a start.
Said warnings_of(const std::string& entities) {
    return said_of_source(entity("worldspawn", {}) + entities + entity_at("info_player_start", {64, 64, 40}));
}

TEST(Warnings, CountOnlyWhatCameSinceTheyWereTaken) {
    map::Warnings warnings;
    warnings.add(3, "it");
    warnings.add(5, "it");
    EXPECT_EQ(taken(warnings), Said{"line 3: it (and 1 more like this)"});
    warnings.add(7, "it");
    EXPECT_EQ(taken(warnings), Said{"line 7: it"});
}

/// Entities, and all that is said of them.
struct Checked {
    const char* entities;
    Said said;
};
const std::vector<Checked> kChecked{
    // What Quake knows, and effects.
    {"light_flame_large_yellow 1 2 3 light=200 style=4 + func_door 0 0 0 8 8 8 lip=8 dmg=2 _tb_group=3 + "
     "monster_shambler 1 2 3 spawnflags=1 + item_key1 1 2 3 sounds=1 + func_button 0 0 0 8 8 8 target=lightning + "
     "event_lightning",
     {}},
    {R"(misc_rain 1 2 3 size="64 64 64" count=200 + misc_sprite 1 2 3 texture={tree shadow=24 +
        info_checkpoint 1 2 3 size="64 64 64")",
     {}},
    {"misc_dust 1 2 3 size=64", {"line 6: 'size' is '64', expected 3 numbers from 1 to 65536"}},
    {"misc_rain 1 2 3 count=131073 period=-3",
     {"line 6: 'count' is '131073', expected a number from 0 to 131072",
      "line 7: 'period' is '-3', expected a number from 0.05 to 3600"}},
    {"misc_model 1 2 3 model=a.obj highlight=256",
     {"line 7: 'highlight' is '256', expected a whole number from 0 to 255"}},
    {"misc_lantern 1 2 3 texture=lamp", {"line 6: 'texture' is 'lamp', expected a texture that begins with '{'"}},
    // Unknown classes and keys by their lines: those of what is not read come last.
    {"fnuc_door angle=90 + func_door 0 0 0 8 8 8 wiat=3",
     {"line 4: the class 'fnuc_door' is unknown, perhaps 'func_door' is meant: the entity is kept unchanged",
      "line 10: nothing reads the key 'wiat' of a func_door, perhaps 'wait' is meant"}},
    {"func_explobox + func_door 0 0 0 8 8 8 wait=x",
     {"line 9: 'wait' is 'x', expected a number",
      "line 4: the class 'func_explobox' is unknown: the entity is kept unchanged"}},
    {"light 1 2 3 targetnmae=x",
     {"line 6: nothing reads the key 'targetnmae' of a light, perhaps 'targetname' is meant"}},
    {"func_explobox angle=90", {"line 4: the class 'func_explobox' is unknown: the entity is kept unchanged"}},
    {"monster_knigth 1 2 3",
     {"line 4: the class 'monster_knigth' is unknown, perhaps 'monster_knight' is meant: the entity is kept "
      "unchanged"}},
    {"light 1 2 3 _project_texture=x",
     {"line 6: nothing reads the key '_project_texture' of a light: lamps shine evenly: no pictures are projected"}},
    {"func_bobbing 0 0 0 8 8 8 angle=90",
     {"line 4: the class 'func_bobbing' is left out (things go from path_corner to path_corner: a `func_train`): the "
      "entity is kept unchanged"}},
    {"func_wall 0 0 0 8 8 8 _shadowself=0", {}},  // it asks for nothing
    // A detail to pass is a model. Editors give an angle to everything.
    {"func_detail_illusionary 0 0 0 8 8 8 _minlight=50", {}},
    {"misc_sprite 1 2 3 texture={tree angle=90 + func_detail 0 0 0 8 8 8 angle=-1", {}},
    {"func_wall 0 0 0 8 8 8 lip=8", {"line 6: nothing reads the key 'lip' of a func_wall"}},
    {R"(misc_rain 1 2 3 fog="1 1 1 1")", {"line 6: nothing reads the key 'fog' of a misc_rain"}},
    {"light 1 2 3 _colour=1 + light 1 2 3 _colour=1 + light 1 2 3 _colour=1",
     {"line 6: nothing reads the key '_colour' of a light, perhaps '_color' is meant (and 2 more like this)"}},
    // Values of another kind.
    {R"(light 1 2 3 _light="255 128 0 400")", {}},
    {"light 1 2 3 delay=4", {"line 6: 'delay' is '4', expected 0, 1, 2, 3 or 5: 0 is taken"}},
    {"light 1 2 3 delay=", {"line 6: 'delay' is '', expected 0, 1, 2, 3 or 5: 0 is taken"}},
    {"light 1 2 3 delay=5", {}},
    {"light 1 2 3 delay=5.0", {}},
    {"light 1 2 3 delay=05", {}},
    {"light 1 2 3 delay=2e0", {}},
    {"light 1 2 3 style=64", {"line 6: 'style' is '64', expected a whole number from 0 to 63"}},
    {"light 1 2 3 target=", {}},  // names nothing
    {R"(light 1 2 3 wait="1 2")", {"line 6: 'wait' is '1 2', expected a number"}},
    {"light 1 2 3 style=candle", {"line 6: 'style' is 'candle', expected a whole number from 0 to 63"}},
    {"light 1 2 3 mangle=up", {"line 6: 'mangle' is 'up', expected 2 to 3 numbers"}},
    {"func_door 0 0 0 8 8 8 speed=fast", {"line 6: 'speed' is 'fast', expected a number"}},
    {"misc_model 1 2 3 model=a.obj up=x", {"line 7: 'up' is 'x', expected y or z: y is taken"}},
    // Targets, names and teleporters. A door with a name stays shut until it is activated.
    {"func_button 0 0 0 8 8 8 target=gate killtarget=wall + func_wall 0 0 0 8 8 8 targetname=wall",
     {"line 6: 'target' is 'gate', but no entity has that name"}},
    {"func_door 0 0 0 8 8 8 targetname=gate",
     {"line 6: 'targetname' is 'gate', but no entity has that target: nothing activates it"}},
    {"func_door 0 0 0 8 8 8 targetname=gate + func_button 0 0 0 8 8 8 target=gate", {}},
    {"func_door 0 0 0 8 8 8 targetname=gate + func_button 0 0 0 8 8 8 killtarget=gate", {}},
    {"trigger_teleport 0 0 0 8 8 8",
     {"line 4: a trigger_teleport without 'target', expected the exit, an `info_teleport_destination`"}},
    {"trigger_teleport 0 0 0 8 8 8 target=x", {"line 6: 'target' is 'x', but no entity has that name"}},
    {"trigger_teleport 0 0 0 8 8 8 target=x + func_wall 0 0 0 8 8 8 targetname=x",
     {"line 6: 'target' is 'x', but the first entity of that name has no origin"}},
    // A key twice, and what a class needs and an entity lacks.
    {"func_door 0 0 0 8 8 8 angle=90 lip=4 angle=0",
     {"line 8: 'angle' is already set in line 6, expected each key once: that one counts"}},
    {"func_door + func_door",
     {"line 4: a func_door without brushes, expected at least one: it has no shape (and 1 more like this)"}},
    {"light 0 0 0 8 8 8", {"line 4: a light with brushes, expected an 'origin' alone: its class is a point"}},
    {"info_teleport_destination", {"line 4: an info_teleport_destination without an 'origin', expected its position"}},
    {"info_player_start 9 9 40 + light 1 2 3",
     {"line 12: a second info_player_start, expected one: that of line 4 counts"}},
};

TEST(Checks, SayOfEntitiesWhatIsOddByTheLine) {
    for (const auto& [entities, said] : kChecked) EXPECT_EQ(warnings_of(entities_of(entities)), said) << entities;
    EXPECT_EQ(warnings_of("{\n\"origin\" \"1 2 3\"\n}\n"), Said{"line 4: an entity without a classname, expected one"});
    EXPECT_EQ(warnings_of(entities_of("func_fnord light=w")).size(), 2u) << "any class may shine";
}

TEST(Checks, MissTheStart) {
    EXPECT_EQ(said_of_source("// a remark\n" + entity("worldspawn", {})),
              Said{"line 2: no info_player_start, expected one: the player has no place to start"});
    EXPECT_EQ(said_of_source(entity("worldspawn", {}) + entity("info_player_start", {})),
              Said{"line 4: an info_player_start without an 'origin', expected its position"});
}

TEST(Checks, KnowTheWorldsKeys) {
    const auto of_world = [](const std::string& pairs) {
        return said_of_source(entities_of("worldspawn " + pairs + " + info_player_start 64 64 40"));
    };
    EXPECT_EQ(of_world(R"(skyfog=0.5 fog="0.5 1 1 1" _wateralpha=0.5 _phong=1 _phong_angle=30
                          palette_cycle="240 243 4" palette_cycle12="240 243 4")"),
              Said{});
    EXPECT_EQ(
        of_world(R"(palette_cycle2="240 243" palette_cycles="1 2 3")"),
        (Said{"line 3: 'palette_cycle2' is '240 243', expected 3 numbers",
              "line 4: nothing reads the key 'palette_cycles' of a worldspawn, perhaps 'palette_cycle' is meant"}));
    const auto said = of_world(R"(fog="0.5 1 1 1" skyfog=2 _wateralpha=-1 fog="-1 1 1 1")");
    ASSERT_EQ(said.size(), 4u);
    EXPECT_EQ(said[0], "line 4: worldspawn key 'skyfog': '2', expected a share from 0 to 1");
    EXPECT_EQ(said[1], "line 5: worldspawn key '_wateralpha': '-1', expected an alpha from 0 to 1");
    EXPECT_TRUE(said[2].starts_with("line 6: worldspawn key 'fog': '-1 1 1 1', expected density")) << said[2];
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

// The room for a player is a box of 32 x 32 x 56 units around a place a unit above the start.
TEST(Checks, NameAStartInAWall) {
    for (const auto& [start, is_in_wall] : {std::pair{Whole{64, 64, 24}, false},
                                            {{16, 112, 24}, false},
                                            {{14, 64, 24}, true},
                                            {{64, 64, 20}, true},
                                            {{64, 64, 97}, true}}) {
        const Said said = said_of(level(room({0, 0, 0}, {128, 128, 128}), entity_at("info_player_start", start)));
        ASSERT_EQ(said.size(), is_in_wall) << start[0] << ' ' << start[2];
        if (!is_in_wall) continue;
        EXPECT_NE(said[0].find(": the info_player_start at "), std::string::npos) << said[0];
        EXPECT_NE(said[0].find(" is in a wall"), std::string::npos) << said[0];
    }
}

// A brush in a wall may be a hidden door; others activate a trigger that has a name, and nobody touches a relay.
TEST(Checks, NameBrushesOutsideOfTheLevel) {
    struct Placed {
        const char* its_class;
        int x;
        const char* name = "";
        std::size_t said = 0;
    };
    std::vector<Placed> all{{"func_door", 64},      {"func_door", 120},                             // half in a wall
                            {"func_door", 136},     {"func_train", 400},      {"func_group", 400},  // is the world's
                            {"trigger_relay", 400}, {"trigger_counter", 400}, {"func_door", 400, "name", 1}};
    for (const char* trigger : {"trigger_multiple", "trigger_once", "trigger_teleport", "trigger_changelevel"})
        all.insert(all.end(), {{trigger, 400, "name"}, {trigger, 400, "", 1}});
    const auto said_of_placed = [](const Placed& row) {
        return said_of(level(room({0, 0, 0}, {128, 128, 128}, 32), entity(row.its_class, {{"targetname", row.name}},
                                                                          box({row.x, 64, 64}, {row.x + 16, 80, 80})) +
                                                                       entity_at("info_player_start", {64, 64, 24})));
    };
    for (const Placed& row : all) EXPECT_EQ(said_of_placed(row).size(), row.said) << row.its_class << row.x << row.name;
    const Said said = said_of_placed({"func_door", 400});
    ASSERT_EQ(said.size(), 1u);
    EXPECT_TRUE(said[0].starts_with("line 52: the brushes of func_door are outside of the level")) << said[0];
}

TEST(Checks, NameAnOriginBrush) {
    const std::string source =
        level(room({0, 0, 0}, {128, 128, 128}),
              entity("func_wall", {}, box({32, 32, 32}, {64, 64, 64}) + box({40, 40, 40}, {48, 48, 48}, "origin")) +
                  entity_at("info_player_start", {64, 64, 24}));
    const Said said = said_of(source);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("texture 'origin'"), std::string::npos) << said[0];
    EXPECT_EQ(compile(source, {true}).models.at(1).face_count, 6) << "the brush beside it";
}

}  // namespace
}  // namespace oblong::test

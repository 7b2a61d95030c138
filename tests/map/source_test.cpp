#include <gtest/gtest.h>

#include <algorithm>

#include "engine/io/files.h"
#include "engine/io/wad.h"
#include "engine/level/entities.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"
#include "tests/support/folders.h"
#include "tests/support/script.h"
#include "tools/map/source/textures.h"

namespace oblong::test {

namespace {

const char* const kHead = "{\n\"classname\" \"worldspawn\"\n";

TEST(MapFile, BadInputIsNamedWithItsLine) {
    const std::string head = kHead, side = head + "{\n( 0 0 0 ) ";
    for (const auto& [source, said] :
         {std::pair<std::string, const char*>{"", "line 1: the first entity is no worldspawn"},
          {"{\n\"classname\" \"worldspawn\"\n}\n", "line 1: the world has no brushes"},
          {"{\n\"classname\" worldspawn\n}", "line 2: found 'worldspawn', expected a value in quotes"},
          {"{\n\"classname\" \"worldspawn\n}", "line 2: found 'worldspawn', expected a closing '\"'"},
          {side + "( 1 0 x )", "line 4: found 'x', expected a number for z"},
          {side + "( 1 0 0 ) ( 0 1 0 ) wall 0 0 0 1\n}", "line 5: found '}'"},
          {head + "{\n", "line 4: the file ends, expected '('"},
          {head + "{\n\"classname\"",
           "line 4: found 'classname', expected '(' of a side, or '}' after what begins in line 3"},
          {head + "\"a\" \"b\"\n",
           "line 4: the file ends, expected a key in quotes, '{' of a brush, or '}' after the entity that begins in "
           "line 1"},
          {side + "( 1 0 1073741825 )", "line 4: found '1073741825', expected a number for z, at most 1073741824"},
          {head + "}\n" + head + "}\n", "line 4: a second worldspawn, expected one, that of line 1"},
          {head + "// a remark\n;", "line 4: found ';', expected a key in quotes"},
          {replaced(head + "// a remark\n;", "\n", "\r\n"), "line 4: found ';', expected a key in quotes"},
          {replaced(head + "// a remark\n;", "\n", "\r"), "line 4: found ';', expected a key in quotes"},
          {side + "( 1 0 nan ) ( 0 1 0 ) wall 0 0 0 1 1", "expected a number"},
          {side + "( 1 0 1e10 ) ( 0 1 0 ) wall 0 0 0 1 1", "expected a number"}})
        expect_complaint(source, said);
}

// A plane may be named by points far outside of the level, and an offset may be any number of textures (of 16 texels).
TEST(MapFile, LargeNumbersAreTakenAsTheyAre) {
    std::vector<map::MapEntity> near = map::parse_map(level(plain_room(), lights_of_plain_room())), far = near;
    for (map::MapBrush& brush : far.front().brushes)
        for (map::MapSide& side : brush.sides) {
            auto& [a, b, c] = side.points;
            const Point u = a - b, v = c - b;
            side.points = {a + u * 152192, b - v * 99999, c + v * 30011};
        }
    const map::BspFile of_far = compile(far, {true}), of_near = compile(near, {true});
    EXPECT_TRUE(of_far.vertices == of_near.vertices && of_far.lighting == of_near.lighting);
    const auto room_of = [](const std::string& tail) {
        return bytes_of(level(replaced(plain_room(), " 0 0 0 1 1\n", tail + "\n"), lights_of_plain_room()));
    };
    EXPECT_EQ(room_of(" 131077 -999995 0 1 1"), room_of(" 5 5 0 1 1"));
    EXPECT_EQ(complaint_of(level(replaced(plain_room(), " 0 0 0 1 1\n", " 0 0 0 100000 -70000\n"), "")), "none");
    const auto side = map::parse_map(
                          "{\n\"classname\" \"worldspawn\"\n{\n( -152192 0 1e6 ) ( 0 152192.5 8 ) ( 7 1 9 ) "
                          "wall [ 1 0 0 131072.25 ] [ 0 1 0 0 ] 0 100000 65537\n}\n}\n")
                          .front()
                          .brushes.front()
                          .sides.front();
    EXPECT_EQ(side.points[0].x, -152192);
    EXPECT_EQ(side.points[0].z, 1000000);
    EXPECT_EQ(side.points[1].y, 152192.5);
    EXPECT_EQ(side.texture.offset[0], 131072.25);
    EXPECT_EQ(side.texture.scale[0], 100000);
}

// An editor's leftover; the entity is what it is without that.
TEST(MapFile, BrushesWithoutSidesAreLeftOut) {
    const std::string empty = "{\n}\n", plain = level(plain_room(), lights_of_plain_room());
    EXPECT_EQ(bytes_of(level(plain_room() + empty + empty, lights_of_plain_room())), bytes_of(plain));
    EXPECT_EQ(bytes_of(level(plain_room(), replaced(lights_of_plain_room(), "\"light\"", "\"light\"\n" + empty))),
              bytes_of(plain));
    map::Warnings warnings;
    map::parse_map(level(plain_room() + empty, entity("func_wall", {}, empty)), &warnings);
    const std::string walls = plain_room();
    const auto line = 3 + std::count(walls.begin(), walls.end(), '\n');
    EXPECT_EQ(taken(warnings), std::vector{"line " + std::to_string(line) +
                                           ": a brush without sides is left out (and 1 more like this)"});
}

TEST(MapFile, AZeroByteIsNamedByItsLine) {
    using namespace std::string_literals;
    const std::string head = level(room({0, 0, 0}, {64, 64, 64})), tail = entity("light", {{"message", "a\0b"s}});
    const auto lines = std::count(head.begin(), head.end(), '\n');
    expect_complaint(head + tail, "line " + std::to_string(lines + 3) + ": a zero byte");
    expect_complaint(head + "\0"s, "line " + std::to_string(lines + 1) + ": a zero byte");
}

// Cut short anywhere, a source is an error or, by chance, a level: nothing else happens.
TEST(MapFile, CutShortAnywhere) {
    const std::string source = level(room({0, 0, 0}, {64, 64, 64}), entity_at("light", {32, 32, 32}));
    for (std::size_t size = 0; size + 2 < source.size(); size += 7)
        EXPECT_NE(complaint_of(source.substr(0, size)), "none") << size;
}

TEST(MapFile, WhatEditorsAddChangesNothing) {
    const std::string plain = level(plain_room(), lights_of_plain_room()), bytes = bytes_of(plain);
    EXPECT_EQ(bytes_of(replaced(plain, "\n", "\r\n")), bytes) << "line ends of DOS";
    EXPECT_EQ(bytes_of(replaced("// Format: Standard\n" + plain, "\n", "\r")), bytes) << "line ends of old Macs";
    EXPECT_EQ(bytes_of("\xef\xbb\xbf" + plain), bytes) << "a byte order mark";
    EXPECT_EQ(bytes_of("// Game: Quake\n// Format: Standard\n// entity 0\n" + plain), bytes);
    EXPECT_EQ(bytes_of(replaced(plain, "( 0 ", "(\t0.000 ")), bytes) << "tabs and decimals";
    EXPECT_EQ(bytes_of(replaced(plain, " 0 0 0 1 1\n", " 0 0 0 1 1 0 0 0\n")), bytes) << "Quake 2's three numbers";
    EXPECT_EQ(bytes_of(replaced(plain, " 0 0 0 1 1\n", " 0 0 0 1 1 ")), bytes) << "a brush's sides in one line";
    EXPECT_EQ(bytes_of(level(plain_room() + box({100, 0, 0}, {108, 256, 128}, "hint"), lights_of_plain_room())), bytes);
}

// A brush entity, a lamp and the world, one of which has one more key.
std::string level_with(const std::string& whose, const std::string& key, const std::string& value) {
    const auto pairs_of = [&](const std::string& name) { return name == whose ? Keys{{key, value}} : Keys{}; };
    return entity("worldspawn", pairs_of("worldspawn"), plain_room()) + entity_at("info_player_start", {64, 64, 40}) +
           entity_at("light", {128, 128, 100}, pairs_of("light")) +
           entity("func_door", pairs_of("func_door"), box({160, 160, 0}, {176, 176, 64}));
}

// The level is that of the same source without the key, but for the entities' text; and what is said names the key.
TEST(Entities, AnUnreadableNumberIsAWarningAndTheDefault) {
    const auto bytes_with = [](const std::string& whose, const std::string& key, const std::string& value) {
        map::BspFile bsp = compile(level_with(whose, key, value), {true});
        bsp.entities.clear();
        return map::to_bytes(bsp);
    };
    const std::string without = bytes_with("", "", "");
    for (const auto& [whose, keys] :
         {std::pair{"light", "light _light delay wait style _color mangle angle radius _surface_offset"},
          {"func_door", "_phong _phong_angle _minlight"},
          {"worldspawn", "light _minlight _phong _sunlight _sunlight2 _sun_mangle _dirt _dirtdepth _bounce"}})
        for (const std::string& key : words_of(keys))
            for (const std::string value : {"", "w", "12units", "0x10", "inf", "nan", "1,5", "99999999999"}) {
                EXPECT_EQ(bytes_with(whose, key, value), without) << key << " \"" << value << '"';
                const auto said = said_of_source(level_with(whose, key, value));
                ASSERT_EQ(said.size(), 1u) << key << " \"" << value << '"';
                EXPECT_NE(said[0].find(": '" + key + "' is '" + value + "', expected "), std::string::npos) << said[0];
            }
    EXPECT_EQ(complaint_of(level(plain_room(), lights_of_plain_room() + entity("light", {{"origin", "1 2"}}))), "none");
}

// Other tools write numbers as C does: 7.1e-15 is none here, 64e0 and 6.4E+1 are 64.
TEST(Entities, NumbersMayHaveExponents) {
    const auto bytes_at = [](const std::string& origin) {
        map::BspFile bsp = compile(level(plain_room(), entity("light", {{"origin", origin}})), {true});
        const Level read = engine_level(bsp);
        EXPECT_EQ(parse_world_vector(read.entities.back().value("origin")),
                  (Vec3<World>{World::from_int(0), World::from_int(64), World::from_int(100)}))
            << origin << ", as the game reads it";
        bsp.entities.clear();
        return map::to_bytes(bsp);
    };
    const std::string expected = bytes_at("0 64 100");
    for (const char* origin : {"7.105427357601002e-15 64 100", "-7.1e-15 64e0 1e2", "0e0 6.4E+1 1000.0e-1",
                               "-0 640000000000000e-13 .0000001e9"})
        EXPECT_EQ(bytes_at(origin), expected) << origin;
}

TEST(Entities, DetailsToPassStopNobody) {
    const auto bsp = compile(
        level(plain_room(), lights_of_plain_room() + entities_of("func_detail_illusionary 160 160 0 192 192 64")),
        {true});
    const Point inside{176, 176, 32};
    for (const int hull : {0, 1, 2}) EXPECT_EQ(contents_at(bsp, 0, hull, {176, 176, 40}), contents::kEmpty) << hull;
    EXPECT_EQ(contents_at(bsp, 1, 0, inside), contents::kSolid) << "of a model";
    EXPECT_EQ(bsp.models.at(1).face_count, 6) << "and drawn";
    EXPECT_NE(bsp.entities.find("\"classname\" \"func_illusionary\"\n\"model\" \"*1\""), std::string::npos)
        << bsp.entities;
}

// A wall of bars from floor to ceiling, between the start with its light and the far half of the room.
std::string hall_with(const std::string& bars_in_world, const std::string& entities) {
    return level(room({0, 0, 0}, {512, 128, 128}) + bars_in_world,
                 entities_of("info_player_start 64 64 40 + light 64 64 64 light=900") + entities);
}

const std::string kBars = box({248, 0, 0}, {264, 128, 128}, "{bars");

std::size_t lit_faces_beyond_the_bars(const map::BspFile& bsp) {
    std::size_t count = 0;
    for (const map::FileFace& face : bsp.faces) {
        bool is_beyond = true;
        for (const Point& corner : corners_of(bsp, face)) is_beyond = is_beyond && corner.x > 264.5;
        count += is_beyond && face.light_offset >= 0;
    }
    return count;
}

void expect_fence(const map::BspFile& bsp) {
    EXPECT_EQ(contents_at(bsp, 0, 0, {256, 64, 64}), contents::kEmpty) << "the world is not cut by the bars";
    const int near = leaf_at(bsp, {64, 64, 64}), far = leaf_at(bsp, {448, 64, 64});
    EXPECT_TRUE(visible_leaves(bsp, near)[as_size(far)]) << "one sees through";
    ASSERT_EQ(bsp.models.size(), 2u);
    EXPECT_GE(bsp.models[1].face_count, 6) << "and sees the bars";
    EXPECT_EQ(contents_at(bsp, 1, 1, {256, 64, 64}), contents::kSolid) << "which stop players";
    EXPECT_GT(lit_faces_beyond_the_bars(bsp), 0u) << "but no light";
}

// id's and ericw's compilers fill brush entities whatever their textures are.
TEST(Entities, OfLiquidOrSkyAreSolid) {
    for (const std::string class_name : {"func_wall", "func_door", "func_button", "func_train"})
        for (const std::string texture : {"*water", "*lava", "sky", "wall"}) {
            const auto bsp =
                compile(level(plain_room(), lights_of_plain_room() +
                                                entity(class_name, {}, box({160, 0, 0}, {176, 256, 128}, texture))),
                        {true});
            const Point inside{168, 128, 64}, beside{152, 128, 64};
            for (const int hull : {0, 1, 2})
                EXPECT_EQ(contents_at(bsp, 1, hull, inside), contents::kSolid) << texture << hull;
            EXPECT_EQ(contents_at(bsp, 1, 0, beside), contents::kEmpty);
            EXPECT_EQ(contents_at(bsp, 1, 1, beside), contents::kSolid) << "16 units are half of a player";
            ASSERT_GE(bsp.models.at(1).face_count, 6);
            const map::FileFace& face = item(bsp.faces, bsp.models[1].first_face);
            EXPECT_EQ(item(bsp.texinfos, face.texinfo).flags, texture == "wall" ? 0 : 1)
                << "it looks as its texture does";
        }
}

TEST(Entities, FencesAreSeenThroughInTheWorldAndInEntities) {
    expect_fence(compile(hall_with(kBars, "")));
    expect_fence(compile(hall_with("", entity("func_wall", {}, kBars))));
    expect_fence(compile(hall_with("", entity("func_detail_fence", {}, kBars))));
    EXPECT_EQ(lit_faces_beyond_the_bars(compile(hall_with(box({248, 0, 0}, {264, 128, 128}), ""))), 0u);
}

TEST(Entities, TexturesThatOnlyEntitiesShowAreInTheLevel) {
    const Level read = engine_level(bytes_of(hall_with("", entities_of("misc_sprite 96 64 40 texture={BARS scale=2"))));
    EXPECT_TRUE(std::any_of(read.textures.begin(), read.textures.end(),
                            [](const MipTexture& texture) { return texture.name == "{bars"; }));
    const auto said = said_of(hall_with("", entities_of("misc_lantern 96 64 40 texture={nosuch")));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("texture '{nosuch' is not in any of the WAD files"), std::string::npos) << said[0];
}

TEST(Entities, LightsWithAStyleOfTheirOwnKeepItFromSwitchableOnes) {
    const auto bsp =
        compile(hall_with("", entities_of("light 96 64 40 style=32 pattern=amz + light 98 64 40 targetname=lamp")));
    EXPECT_NE(bsp.entities.find("\"style\" \"33\""), std::string::npos) << bsp.entities;
}

TEST(Entities, QuotesBehindBackslashesArePartOfAValue) {
    const std::string sign = entity("trigger_multiple", {{"message", R"(say \"hi\" now)"}, {"wad", R"(C:\gfx\)"}},
                                    box({160, 160, 0}, {192, 192, 64}, "trigger"));
    const Level read = engine_level(bytes_of(level(plain_room(), lights_of_plain_room() + sign)));
    EXPECT_EQ(read.entities.back().value("message"), R"(say \"hi\" now)");
    EXPECT_EQ(read.entities.back().value("wad"), R"(C:\gfx\)");
}

TEST(Entities, GroupsAloneAreAWorld) {
    const std::string bytes = bytes_of(level(plain_room(), lights_of_plain_room()));
    EXPECT_EQ(
        bytes_of(level("", entity("func_group", {{"_tb_type", "_tb_group"}}, plain_room()) + lights_of_plain_room())),
        bytes);
}

// As TrenchBroom saves them: layer by layer, each with its brushes, details and entities.
TEST(Entities, InWhichOrderLayersAreSavedMakesNoDifference) {
    const std::string pillar = box({160, 160, 0}, {192, 192, 64}), step = box({200, 160, 0}, {232, 192, 16});
    const std::string group = entity("func_group", {{"_tb_type", "_tb_layer"}, {"_tb_id", "1"}}, pillar),
                      detail = entity("func_detail", {{"_tb_layer", "1"}}, step),
                      door = entities_of("func_door 96 96 0 112 112 64 _tb_layer=1");
    const std::string bytes = bytes_of(level(plain_room(), lights_of_plain_room() + group + detail + door));
    EXPECT_EQ(bytes_of(level(plain_room(), lights_of_plain_room() + door + detail + group)), bytes);
    EXPECT_EQ(bytes_of(level(plain_room() + pillar, lights_of_plain_room() + detail + door)), bytes);
}

// The same as without them: what is in the layer, in a group of it, or in a group of that, and entities without
// brushes.
TEST(Entities, LayersThatTheEditorDoesNotExportAreLeftOut) {
    const std::string pillar = box({160, 160, 0}, {192, 192, 64}), far_lamp = "2000 0 0";
    const auto layer = [](const std::string& id, const std::string& omits, const std::string& brushes) {
        Keys pairs{{"_tb_type", "_tb_layer"}, {"_tb_name", "l"}, {"_tb_id", id}};
        if (!omits.empty()) pairs.push_back({"_tb_layer_omit_from_export", omits});
        return entity("func_group", pairs, brushes);
    };
    const auto group = [](const std::string& id, const std::string& key, const std::string& of,
                          const std::string& brushes) {
        return entity("func_group", {{"_tb_type", "_tb_group"}, {"_tb_id", id}, {key, of}}, brushes);
    };
    const auto things_of = [&](const std::string& key, const std::string& of) {
        return entity("light", {{"origin", far_lamp}, {key, of}}) + entity("func_door", {{key, of}}, pillar) +
               entity("func_detail", {{key, of}}, pillar);
    };
    const std::string room_alone = level(plain_room(), lights_of_plain_room()), bytes = bytes_of(room_alone);
    const std::string groups = group("2", "_tb_layer", "1", pillar) + group("3", "_tb_group", "2", pillar);
    const std::string all =
        groups + things_of("_tb_layer", "1") + things_of("_tb_group", "2") + things_of("_tb_group", "3");
    EXPECT_EQ(bytes_of(room_alone + layer("1", "1", pillar) + all), bytes);
    EXPECT_EQ(bytes_of(room_alone + all + layer("1", "1", pillar)), bytes) << "a layer behind what is in it";
    for (const std::string omits : {"", "0"})
        EXPECT_NE(complaint_of(room_alone + layer("1", omits, pillar) + all), "none") << "its lamps are outside";
    // The layer of what names none is the worldspawn's; the group 1 is another thing than the layer 1.
    const std::string in_layer = lights_of_plain_room();
    EXPECT_EQ(
        bytes_of(entity("worldspawn", {{"_tb_layer_omit_from_export", "1"}}, pillar) + things_of("targetname", "x") +
                 layer("1", "", plain_room()) + replaced(in_layer, "\"origin\"", "\"_tb_layer\" \"1\"\n\"origin\"")),
        bytes);
    EXPECT_EQ(bytes_of(room_alone + layer("4", "1", "") + group("4", "_tb_layer", "5", "") +
                       entity("func_detail", {{"_tb_group", "4"}}, pillar)),
              bytes_of(room_alone + entity("func_detail", {}, pillar)));
    EXPECT_NE(complaint_of(room_alone + group("7", "_tb_group", "7", "") + things_of("_tb_group", "7")), "none")
        << "a loop";
}

TEST(Entities, NothingOfTheSourceAloneIsInTheLevel) {
    const std::string layer = entity("func_group", {{"_tb_type", "_tb_layer"}, {"_tb_name", "lights alone"}});
    const std::string source = level(plain_room(), lights_of_plain_room());
    std::string saved = source;
    saved.insert(saved.find("\"classname\" \"worldspawn\""),
                 "\"mapversion\" \"220\"\n\"_tb_def\" \"external:a.fgd\"\n");
    EXPECT_EQ(bytes_of(saved + layer), bytes_of(source));
    EXPECT_TRUE(said_of_source(saved + layer).empty());
}

TEST(Entities, ALevelNamesItsWadsWithoutTheirFolders) {
    std::string source = level(plain_room(), lights_of_plain_room());
    source.insert(source.find("\"classname\" \"worldspawn\""), R"("wad" "../a/b.wad;C:\c\d.wad;e.wad")"
                                                               "\n");
    EXPECT_NE(compile(source).entities.find("\"wad\" \"b.wad;d.wad;e.wad\"\n"), std::string::npos);
}

// What is said of the textures `names`, used in lines 7, 8 ..., and the textures as the engine reads them.
std::vector<std::string> said_of_textures(const std::vector<std::string>& names, const std::string& wad,
                                          std::vector<MipTexture>* read = nullptr) {
    std::vector<map::TextureUse> uses;
    for (const std::string& name : names) uses.push_back({name, 7 + static_cast<int>(uses.size())});
    map::Warnings warnings;
    for (const std::string& texture : map::collect_textures(uses, {map::Wad(wad)}, warnings))
        if (read != nullptr)
            read->push_back(parse_miptex({reinterpret_cast<const std::uint8_t*>(texture.data()), texture.size()}));
    return taken(warnings);
}

TEST(Wad, TexturesThatTheEngineDoesNotReadAreNamed) {
    constexpr std::size_t kMiptex = 12, kWidth = kMiptex + 16, kFirstMip = kMiptex + 24;
    for (const auto& [at, value, said] :
         {std::tuple{kWidth, 20, "20x"}, {kWidth + 1, 1, ""}, {kFirstMip, 0, "mip level 0 at offset 0"}}) {
        std::string wad = wad_bytes(std::vector<std::string>{"wall"});
        wad[at] = static_cast<char>(value);
        const auto all = said_of_textures({"wall"}, wad);
        ASSERT_EQ(all.size(), 1u) << at;
        EXPECT_TRUE(all[0].starts_with("line 7: texture 'wall' of the WAD: " + std::string(said))) << all[0];
    }
}

// Squares of 8 texels, as the engine's own for textures without texels; all missing ones are named at once.
TEST(Wad, AMissingTextureIsACheckerboard) {
    const std::string wad = wad_bytes(std::vector<std::string>{"wall", "+0lamp"}), tail = ": a checkerboard is shown";
    std::vector<MipTexture> read;
    const auto said = said_of_textures({"wall", "wlal", "sky1", "*no/such/long/name", "+0lamp", "{bars"}, wad, &read);
    ASSERT_EQ(said.size(), 4u);
    EXPECT_EQ(said[0],
              "line 8: texture 'wlal' is not in any of the WAD files, perhaps 'wall' is meant, expected its WAD "
              "in worldspawn's 'wad' or in --wad" +
                  tail);
    for (std::size_t i : {0u, 1u, 2u, 3u}) EXPECT_TRUE(said[i].ends_with(tail)) << said[i];
    ASSERT_EQ(read.size(), 6u);
    EXPECT_EQ(read[0].width, 16);
    EXPECT_EQ(read[2].width, 2 * read[2].height) << "a sky is two squares";
    EXPECT_EQ(read[3].name, "*no/such/long/n") << "as much as a level's texture can have";
    for (const std::size_t i : {1u, 2u, 3u, 5u})
        for (std::size_t mip = 0; mip < 4; ++mip) {
            const int width = read[i].width >> mip, square = 8 >> mip;
            for (int at = 0; at < width * (read[i].height >> mip); ++at)
                ASSERT_EQ(read[i].mips[mip][as_size(at)] == 15, (at % width / square + at / width / square) % 2 == 0)
                    << i << ", mip level " << mip;
        }
}

TEST(Wad, AnimationsWithGapsAndSkiesOfAnotherShapeAreNamed) {
    using Warned = std::vector<std::string>;
    const auto gap = [](const std::string& used, const std::string& last, const std::string& missing) {
        return Warned{"line 7: the animation of '" + used + "' has '" + last + "' but no '" + missing +
                      "', expected frames without gaps"};
    };
    for (const auto& [frames, said] : {std::pair<std::vector<std::string>, Warned>{{"+0lamp", "+1lamp", "+alamp"}, {}},
                                       {{"+0lamp", "+2lamp", "+3lamp"}, gap("+0lamp", "+2lamp", "+1lamp")},
                                       {{"+2lamp"}, gap("+2lamp", "+2lamp", "+0lamp")},
                                       {{"+0lamp", "+blamp"}, gap("+0lamp", "+blamp", "+alamp")}})
        EXPECT_EQ(said_of_textures({frames[0]}, wad_bytes(frames)), said);
    const auto said_of_sky = [](std::uint32_t width, std::uint32_t height) {
        return said_of_textures({"sky1"}, wad_bytes({StripedTexture{"sky1", 1, 2, width, height}}));
    };
    EXPECT_EQ(said_of_sky(256, 128), Warned{});
    EXPECT_EQ(said_of_sky(32, 16), Warned{});
    EXPECT_EQ(said_of_sky(128, 128),
              Warned{"line 7: the sky 'sky1' has 128x128 texels, expected two squares side by side"});
}

TEST(Wad, TexturesHaveTheNameThatTheyAreFoundBy) {
    for (const std::string& own : {std::string(), std::string("inner"), std::string("WALL")}) {
        std::string bytes = wad_bytes(std::vector<std::string>{"wall"});
        bytes.replace(12, 16, own + std::string(16 - own.size(), '\0'));
        map::Warnings unheard;
        const std::string texture = map::collect_textures({{"wall", 7}}, {map::Wad(bytes)}, unheard).at(0);
        EXPECT_EQ(std::string(texture.c_str()), own == "WALL" ? own : "wall");
        EXPECT_EQ(texture.substr(16), bytes.substr(28, texture.size() - 16));
    }
}

map::BspFile compile_shared(const std::string& name) {
    const auto folder = find_shared_folder() / "levels";
    std::vector<map::Wad> wads;
    for (const char* wad : {"gfx/metal.wad", "gfx/wizard.wad"}) wads.emplace_back(read_text((folder / wad).string()));
    return map::compile_map(map::parse_map(read_text((folder / (name + ".map")).string())), wads, {true});
}

TEST(RealSources, AreSealedAndReadable) {
    OBLONG_NEEDS_SHARED_LEVELS();
    for (const std::string name : kRealLevels) {
        const auto bsp = compile_shared(name);
        EXPECT_EQ(open_edges(bsp), 0) << name;
        EXPECT_EQ(first_fault_of_rays(bsp, 1500, 7), "") << name;
        const std::string bytes = map::to_bytes(bsp);
        const Level level = engine_level(bytes);
        EXPECT_EQ(level.models.size(), bsp.models.size()) << name;
        EXPECT_EQ(map::to_bytes(compile_shared(name)), bytes) << name << ": the same bytes each time";
    }
}

}  // namespace

}  // namespace oblong::test

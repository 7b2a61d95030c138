#include <gtest/gtest.h>

#include <algorithm>

#include "engine/files/files.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"
#include "tests/support/folders.h"
#include "tests/support/refusal.h"
#include "tools/map/source/textures.h"

namespace oblong::test {

namespace {

const char* const kHead = "{\n\"classname\" \"worldspawn\"\n";

TEST(MapFile, BadInputIsNamedWithItsLine) {
    expect_complaint("", "line 1: the first entity is no worldspawn");
    expect_complaint("{\n\"classname\" \"worldspawn\"\n}\n", "line 1: the world has no brushes");
    expect_complaint("{\n\"classname\" worldspawn\n}", "line 2: found 'worldspawn', expected a value in quotes");
    expect_complaint("{\n\"classname\" \"worldspawn\n}", "line 2: found 'worldspawn', expected a closing '\"'");
    expect_complaint(std::string(kHead) + "{\n( 0 0 0 ) ( 1 0 x )", "line 4: found 'x', expected a number for z");
    expect_complaint(std::string(kHead) + "{\n( 0 0 0 ) ( 1 0 0 ) ( 0 1 0 ) wall 0 0 0 1\n}", "line 5: found '}'");
    expect_complaint(std::string(kHead) + "{\n", "line 4: the file ends, expected '('");
    expect_complaint(std::string(kHead) + "{\n\"classname\"",
                     "line 4: found 'classname', expected '(' of a side, or '}' after what begins in line 3");
    expect_complaint(std::string(kHead) + "\"a\" \"b\"\n",
                     "line 4: the file ends, expected a key in quotes, '{' of a brush, or '}' after the entity that "
                     "begins in line 1");
    expect_complaint(std::string(kHead) + "{\n( 0 0 0 ) ( 1 0 65537 )",
                     "line 4: found '65537', expected a number for z, at most 65536");
    expect_complaint(std::string(kHead) + "}\n" + kHead + "}\n",
                     "line 4: a second worldspawn, expected one, that of line 1");
    for (const std::string end : {"\n", "\r\n", "\r"})
        expect_complaint(replaced(std::string(kHead) + "// a remark\n;", "\n", end),
                         "line 4: found ';', expected a key in quotes");
    expect_complaint(std::string(kHead) + "{\n( 0 0 0 ) ( 1 0 nan ) ( 0 1 0 ) wall 0 0 0 1 1", "expected a number");
    expect_complaint(std::string(kHead) + "{\n( 0 0 0 ) ( 1 0 1e9 ) ( 0 1 0 ) wall 0 0 0 1 1", "expected a number");
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

TEST(Entities, MalformedNumbersAreRefused) {
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}), entity("light", {{"origin", "1 2"}})),
                     "\"origin\" is \"1 2\", expected 3 decimal numbers");
    const std::string plain = level(room({0, 0, 0}, {64, 64, 64}));
    const auto line = 3 + std::count(plain.begin(), plain.end(), '\n');  // after "{" and classname
    for (const std::string value : {"bright", "1e9", "300units", "99999999999", "0x10", "inf", ""})
        expect_complaint(
            plain + entity_at("light", {32, 32, 32}, {{"light", value}}),
            "line " + std::to_string(line) + ": \"light\" is \"" + value + "\", expected 1 decimal number");
}

TEST(Entities, DetailsToPassStopNobody) {
    const auto bsp = compile(level(plain_room(), lights_of_plain_room() + entity("func_detail_illusionary", {},
                                                                                 box({160, 160, 0}, {192, 192, 64}))),
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
    return level(
        room({0, 0, 0}, {512, 128, 128}) + bars_in_world,
        entity_at("info_player_start", {64, 64, 40}) + entity_at("light", {64, 64, 64}, {{"light", "900"}}) + entities);
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
    EXPECT_TRUE(visible_leaves(bsp, near)[static_cast<std::size_t>(far)]) << "one sees through";
    ASSERT_EQ(bsp.models.size(), 2u);
    EXPECT_GE(bsp.models[1].face_count, 6) << "and sees the bars";
    EXPECT_EQ(contents_at(bsp, 1, 1, {256, 64, 64}), contents::kSolid) << "which stop players";
    EXPECT_GT(lit_faces_beyond_the_bars(bsp), 0u) << "but no light";
}

TEST(Entities, FencesAreSeenThroughInTheWorldAndInEntities) {
    expect_fence(compile(hall_with(kBars, "")));
    expect_fence(compile(hall_with("", entity("func_wall", {}, kBars))));
    expect_fence(compile(hall_with("", entity("func_detail_fence", {}, kBars))));
    EXPECT_EQ(lit_faces_beyond_the_bars(compile(hall_with(box({248, 0, 0}, {264, 128, 128}), ""))), 0u);
}

TEST(Entities, TexturesThatOnlyEntitiesShowAreInTheLevel) {
    const Level read = engine_level(
        bytes_of(hall_with("", entity_at("misc_sprite", {96, 64, 40}, {{"texture", "{BARS"}, {"scale", "2"}}))));
    EXPECT_TRUE(std::any_of(read.textures.begin(), read.textures.end(),
                            [](const MipTexture& texture) { return texture.name == "{bars"; }));
    expect_complaint(hall_with("", entity_at("misc_lantern", {96, 64, 40}, {{"texture", "{nosuch"}})),
                     "texture '{nosuch' is not in any of the WAD files");
}

TEST(Entities, LightsWithAStyleOfTheirOwnKeepItFromSwitchableOnes) {
    const auto bsp = compile(hall_with("", entity_at("light", {96, 64, 40}, {{"style", "32"}, {"pattern", "amz"}}) +
                                               entity_at("light", {98, 64, 40}, {{"targetname", "lamp"}})));
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
                      door = entity("func_door", {{"_tb_layer", "1"}}, box({96, 96, 0}, {112, 112, 64}));
    const std::string bytes = bytes_of(level(plain_room(), lights_of_plain_room() + group + detail + door));
    EXPECT_EQ(bytes_of(level(plain_room(), lights_of_plain_room() + door + detail + group)), bytes);
    EXPECT_EQ(bytes_of(level(plain_room() + pillar, lights_of_plain_room() + detail + door)), bytes);
}

TEST(Entities, NothingOfTheSourceAloneIsInTheLevel) {
    const std::string layer = entity("func_group", {{"_tb_type", "_tb_layer"}, {"_tb_name", "lights alone"}});
    const std::string source = level(plain_room(), lights_of_plain_room());
    std::string saved = source;
    saved.insert(saved.find("\"classname\" \"worldspawn\""),
                 "\"mapversion\" \"220\"\n\"_tb_def\" \"external:a.fgd\"\n");
    EXPECT_EQ(bytes_of(saved + layer), bytes_of(source));
    map::Warnings warnings;
    find_warnings(map::parse_map(saved + layer), warnings);
    EXPECT_TRUE(warnings.take().empty());
}

TEST(Entities, ALevelNamesItsWadsWithoutTheirFolders) {
    std::string source = level(plain_room(), lights_of_plain_room());
    source.insert(source.find("\"classname\" \"worldspawn\""), R"("wad" "../a/b.wad;C:\c\d.wad;e.wad")"
                                                               "\n");
    EXPECT_NE(compile(source).entities.find("\"wad\" \"b.wad;d.wad;e.wad\"\n"), std::string::npos);
}

std::string fault_of_texture(const std::string& wad) {
    const std::vector<map::Wad> wads{map::Wad(wad)};
    return refusal([&] { map::collect_textures({{"wall", 7}}, wads); });
}

TEST(Wad, TexturesThatTheEngineDoesNotReadAreNamed) {
    std::string odd = wad_bytes(std::vector<std::string>{"wall"}), cut = odd, header = odd;
    constexpr std::size_t kMiptex = 12, kWidth = kMiptex + 16, kFirstMip = kMiptex + 24;
    odd[kWidth] = 20;
    EXPECT_TRUE(fault_of_texture(odd).starts_with("line 7: texture 'wall' of the WAD: 20x")) << fault_of_texture(odd);
    cut[kWidth + 1] = 1;
    EXPECT_TRUE(fault_of_texture(cut).starts_with("line 7: texture 'wall' of the WAD: ")) << fault_of_texture(cut);
    header[kFirstMip] = 0;
    EXPECT_TRUE(fault_of_texture(header).starts_with("line 7: texture 'wall' of the WAD: mip level 0 at offset 0"));
}

TEST(Wad, TexturesHaveTheNameThatTheyAreFoundBy) {
    for (const std::string& own : {std::string(), std::string("inner"), std::string("WALL")}) {
        std::string bytes = wad_bytes(std::vector<std::string>{"wall"});
        bytes.replace(12, 16, own + std::string(16 - own.size(), '\0'));
        const std::string texture = map::collect_textures({{"wall", 7}}, {map::Wad(bytes)}).at(0);
        EXPECT_EQ(std::string(texture.c_str()), own == "WALL" ? own : "wall");
        EXPECT_EQ(texture.substr(16), bytes.substr(28, texture.size() - 16));
    }
}

TEST(Wad, UnknownTexturesAreNamed) {
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}, 16, "nothing")),
                     "line 4: texture 'nothing' is not in any of the WAD files: add");
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}, 16, "wlal")),
                     "line 4: texture 'wlal' is not in any of the WAD files, perhaps 'wall' is meant: add");
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

#include "tools/map/light/level_checks.h"

#include <gtest/gtest.h>

#include "tests/map/map_source.h"

namespace oblong::test::level_checks_test {
namespace {

using Said = std::vector<std::string>;

int line_of(const std::string& source, const std::string& part) {
    const auto end = source.begin() + static_cast<std::ptrdiff_t>(source.find(part));
    return 1 + static_cast<int>(std::count(source.begin(), end, '\n'));
}

// That one warning is said of a source, which has this text; returns the number of its line.
int line_of_only(const std::string& source, const std::string& text) {
    const Said said = said_of(source);
    EXPECT_EQ(said.size(), 1u) << text;
    EXPECT_NE(said.at(0).find(": " + text), std::string::npos) << said[0];
    return std::stoi(said[0].substr(5));
}

const std::string kStart = entity_at("info_player_start", {64, 64, 24});

std::string laid(const std::string& brushes, const std::string& tail) {
    return replaced(brushes, " 0 0 0 1 1", " " + tail);
}

TEST(LevelChecks, AreSilentAboutAPlainRoom) {
    EXPECT_EQ(said_of(level(room({0, 0, 0}, {256, 256, 128}), kStart + entity_at("light", {128, 128, 64}))), Said{});
}

TEST(LevelChecks, NameATextureThatNoFaceShows) {
    const std::string inside_of_a_wall = box({-12, 8, 8}, {-4, 16, 16}, "other");
    const std::string source = level(room({0, 0, 0}, {128, 128, 128}) + inside_of_a_wall, kStart);
    EXPECT_EQ(line_of_only(source,
                           "no visible face has the texture 'other', which is 380 bytes of the level: "
                           "expected 'skip' on its sides"),
              line_of(source, " other "));
    const std::string seen = level(room({0, 0, 0}, {128, 128, 128}) + box({8, 8, 8}, {16, 16, 16}, "other"), kStart);
    EXPECT_EQ(said_of(seen), Said{});
    const std::string sprite = entity_at("misc_sprite", {64, 64, 64}, {{"texture", "{bars"}});
    EXPECT_EQ(said_of(level(room({0, 0, 0}, {128, 128, 128}), kStart + sprite)), Said{}) << "an entity shows it";
}

// At a scale of 1/128, 128 units are 16384 texels: 69 faces of at most 240 in each direction.
TEST(LevelChecks, NameTheViewOfTooManyFaces) {
    const std::string floor = laid(box({0, 0, -16}, {128, 128, 0}, "floor"), "0 0 0 0.0078125 0.0078125");
    const std::vector<std::string> said = said_of(level(room({0, 0, 0}, {128, 128, 128}) + floor, kStart));
    EXPECT_EQ(
        said.front(),
        "line 1: 4766 faces may be visible from around 64 64 64, expected at most 4000: hide rooms from each other "
        "behind walls, or make textures of what is small");
}

// 128 units at a scale of 1/20 are 2560 texels, which is 11 times the 240 of a face; at 1/16 they are 2048.
TEST(LevelChecks, NameASurfaceThatIsTooLargeForACache) {
    const auto source_of = [](const std::string& scale) {
        const std::string floor = laid(box({0, 0, -16}, {128, 128, 0}, "floor"), "0 0 0 " + scale + " " + scale);
        return level(room({0, 0, 0}, {128, 128, 128}) + floor, kStart);
    };
    EXPECT_GE(line_of_only(source_of("0.05"),
                           "a surface of 'floor' has 6553600 texels in 121 faces, more than an engine's surface cache "
                           "holds (4194304): expected texture scales 2 times as large, or a smaller surface"),
              line_of(source_of("0.05"), " floor "));
    EXPECT_EQ(said_of(source_of("0.0625")), Said{});
}

// Each side of 32 x 128 units needs 3 x 9 samples, and takes 4 x 10 half a step off the grid; the ends 3 x 3 and 4 x 4.
TEST(LevelChecks, NameTexturesThatLieOffTheGridOfLight) {
    const auto source_of = [](const std::string& tail) {
        return level(laid(room({0, 0, 0}, {32, 32, 128}), tail), entity_at("info_null", {16, 16, 24}));
    };
    EXPECT_GT(line_of_only(source_of("8 8 0 1 1"), "66 of 192 light samples are outside of their faces"), 1)
        << "the line of a side";
    EXPECT_EQ(said_of(source_of("16 32 0 1 1")), Said{});
    // 6 faces of 32 x 32 units have 7 too many each: more than a quarter, but few.
    EXPECT_EQ(said_of(level(laid(room({0, 0, 0}, {32, 32, 32}), "8 8 0 1 1"), entity_at("info_null", {16, 16, 24}))),
              Said{});
    // 128 x 128 units need 9 x 9 and have 10 x 10 then: 114 too many, but less than a quarter.
    EXPECT_EQ(said_of(level(laid(room({0, 0, 0}, {128, 128, 128}), "8 8 0 1 1"), kStart)), Said{});
}

// 127 units from the nearest samples, which are a unit over the walls; a shade is 4 of 255, and light is halved.
TEST(LevelChecks, NameALampThatLightsNothing) {
    const auto room_with = [](const char* key, const char* value) {
        return level(room({0, 0, 0}, {256, 256, 256}), kStart + entity_at("light", {128, 128, 128}, {{key, value}}));
    };
    for (const char* dark : {"100", "134", "-134"})
        line_of_only(room_with("light", dark),
                     "the light at 128 128 128 lights no face visibly, expected a larger \"light\", or a place nearer "
                     "to a face");
    for (const char* bright : {"136", "-136", "300"}) EXPECT_EQ(said_of(room_with("light", bright)), Said{}) << bright;
    line_of_only(room_with("_surface", "gone"), "\"_surface\" is 'gone', but no visible face has that texture");
}

// Version 29 counts clip nodes with 15 bits.
TEST(LevelChecks, NameListsThatAreNearlyFull) {
    const auto said_with = [](std::size_t count) {
        map::BspFile bsp;
        bsp.clip_nodes.resize(count);
        map::Warnings warnings;
        map::find_level_warnings(bsp, map::parse_map("{\n\"classname\" \"worldspawn\"\n}\n"), {}, warnings);
        std::string all;
        for (const map::Warning& warning : warnings.take()) all += warning.what + ";";
        return all;
    };
    EXPECT_EQ(said_with(29000), "");
    EXPECT_EQ(said_with(30000),
              "30000 of 32767 clip nodes: with more the level would be BSP2; reduce them by 'clip' "
              "brushes around fine shapes;");
    EXPECT_EQ(said_with(32768),
              "32768 of 32767 clip nodes: the level is written as BSP2, which fewer programs read; "
              "reduce them by 'clip' brushes around fine shapes;");
}

TEST(LevelChecks, NameWadsOfWhichNothingIsUsed) {
    using Names = std::vector<std::string>;
    std::vector<map::Wad> wads;
    for (const Names& names : {Names{"wall"}, Names{"wall", "other"}, Names{"other"}})
        wads.emplace_back(wad_bytes(names));
    for (map::Wad& wad : wads) wad.source = "w" + std::to_string(wad.line = 7 + static_cast<int>(&wad - wads.data()));
    const auto said_of_use = [&](const std::vector<map::TextureUse>& names) {
        map::Warnings warnings;
        map::find_unused_wads(wads, names, warnings);
        std::string lines;
        for (const map::Warning& warning : warnings.take()) lines += std::to_string(warning.line) + warning.what + ";";
        return lines;
    };
    EXPECT_EQ(said_of_use({{"wall", 1}, {"other", 1}}), "9no texture of 'w9' is used: remove it from \"wad\";");
    EXPECT_EQ(said_of_use({{"other", 1}}).substr(0, 23), "7no texture of 'w7' is ");
    wads[2].line = 0;
    EXPECT_EQ(said_of_use({{"wall", 1}, {"other", 1}}), "") << "it was named on the command line";
}

}  // namespace
}  // namespace oblong::test::level_checks_test

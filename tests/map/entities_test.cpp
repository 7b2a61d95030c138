#include <gtest/gtest.h>

#include <algorithm>

#include "engine/level/bsp_read.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

TEST(Entities, MalformedNumbersAreRefused) {
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}), entity("light", {{"origin", "1 2"}})),
                     "\"origin\" is \"1 2\", expected 3 numbers");
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}), entity_at("light", {32, 32, 32}, {{"light", "bright"}})),
                     "\"light\" is \"bright\", expected 1 number");
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
    const std::string bytes =
        bytes_of(hall_with("", entity_at("misc_sprite", {96, 64, 40}, {{"texture", "{BARS"}, {"scale", "2"}})));
    const Level read = read_bsp({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    EXPECT_TRUE(std::any_of(read.textures.begin(), read.textures.end(),
                            [](const MipTexture& texture) { return texture.name == "{bars"; }));
    expect_complaint(hall_with("", entity_at("misc_lantern", {96, 64, 40}, {{"texture", "{nosuch"}})),
                     "texture '{nosuch' is in none of the WAD files");
}

TEST(Entities, LightsWithAStyleOfTheirOwnKeepItFromSwitchableOnes) {
    const auto bsp = compile(hall_with("", entity_at("light", {96, 64, 40}, {{"style", "32"}, {"pattern", "amz"}}) +
                                               entity_at("light", {98, 64, 40}, {{"targetname", "lamp"}})));
    EXPECT_NE(bsp.entities.find("\"style\" \"33\""), std::string::npos) << bsp.entities;
}

TEST(Entities, QuotesBehindBackslashesArePartOfAValue) {
    const std::string sign = entity("trigger_multiple", {{"message", R"(say \"hi\" now)"}, {"wad", R"(C:\gfx\)"}},
                                    box({160, 160, 0}, {192, 192, 64}, "trigger"));
    const std::string bytes = bytes_of(level(plain_room(), lights_of_plain_room() + sign));
    const Level read = read_bsp({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
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

}  // namespace
}  // namespace oblong::test

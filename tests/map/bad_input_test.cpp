#include <gtest/gtest.h>

#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

// Where and what a compilation complains of.
std::string complaint_of(const std::string& source) {
    try {
        compile(source, {true});
    } catch (const InputError& error) {
        return error.where + ": " + error.what();
    }
    return "none";
}

void expect_complaint(const std::string& source, const std::string& part) {
    EXPECT_NE(complaint_of(source).find(part), std::string::npos) << complaint_of(source);
}

const char* const kHead = "{\n\"classname\" \"worldspawn\"\n";

TEST(BadInput, IsNamedWithItsLine) {
    expect_complaint("", "line 1: the first entity is no worldspawn");
    expect_complaint("{\n\"classname\" \"worldspawn\"\n}\n", "line 1: the world has no brushes");
    expect_complaint("{\n\"classname\" worldspawn\n}", "line 2: found 'worldspawn', expected a value in quotes");
    expect_complaint("{\n\"classname\" \"worldspawn\n}", "line 2: found 'worldspawn', expected a closing '\"'");
    expect_complaint(std::string(kHead) + "{\n( 0 0 0 ) ( 1 0 x )", "line 4: found 'x', expected a number for z");
    expect_complaint(std::string(kHead) + "{\n( 0 0 0 ) ( 1 0 0 ) ( 0 1 0 ) wall 0 0 0 1\n}", "line 5: found '}'");
    expect_complaint(std::string(kHead) + "{\n", "line 4: the file ends, expected '('");
    expect_complaint(std::string(kHead) + "// a remark\n;", "line 4: found ';', expected a key in quotes");
    expect_complaint(std::string(kHead) + "{\n( 0 0 0 ) ( 1 0 nan ) ( 0 1 0 ) wall 0 0 0 1 1", "expected a number");
    expect_complaint(std::string(kHead) + "{\n( 0 0 0 ) ( 1 0 1e9 ) ( 0 1 0 ) wall 0 0 0 1 1", "expected a number");
}

TEST(BadInput, PlanesAndBrushesWithoutExtent) {
    expect_complaint(std::string(kHead) + "{\n( 0 0 0 ) ( 1 1 1 ) ( 2 2 2 ) wall 0 0 0 1 1\n}\n}\n",
                     "line 4: the three points of a plane lie on one line");
    expect_complaint(level(brush({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}})), "enclose no volume");
    expect_complaint(level(box({0, 0, 0}, {0, 16, 16})), "the three points of a plane lie on one line");
    expect_complaint(level(box({16, 0, 0}, {0, 16, 16})), "line 3: the sides of this brush enclose no volume");
}

TEST(BadInput, UnknownTextures) {
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}, 16, "nothing")), "line 4: texture 'nothing' is in none");
}

TEST(BadInput, NumbersOfEntities) {
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}), entity("light", {{"origin", "1 2"}})),
                     "\"origin\" is \"1 2\", expected 3 numbers");
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}), entity_at("light", {32, 32, 32}, {{"light", "bright"}})),
                     "\"light\" is \"bright\", expected 1 number");
}

TEST(BadInput, BrokenWads) {
    EXPECT_THROW(map::Wad("WAD3"), InputError);
    EXPECT_THROW(map::Wad("WAD2"), InputError);
    const std::string whole = wad_bytes({"wall"});
    EXPECT_NE(map::Wad(whole).find("wall"), nullptr);
    EXPECT_THROW(map::Wad(whole.substr(0, whole.size() - 1)), InputError);
    std::string far = whole;
    far.replace(whole.size() - 32, 4, "\xff\xff\xff\x7f");
    EXPECT_THROW(map::Wad{far}, InputError);
}

// Cut short anywhere, a source is an error or, by chance, a level: nothing else happens.
TEST(BadInput, CutShortAnywhere) {
    const std::string source = level(room({0, 0, 0}, {64, 64, 64}), entity_at("light", {32, 32, 32}));
    for (std::size_t size = 0; size + 2 < source.size(); size += 7)
        EXPECT_NE(complaint_of(source.substr(0, size)), "none") << size;
}

TEST(Leak, NamesTheEntityAndTheWayOut) {
    const std::string source = level(room({0, 0, 0}, {256, 256, 128}),
                                     entity_at("info_player_start", {128, 128, 32}) + entity_at("light", {400, 0, 0}));
    try {
        compile(source, {true});
        FAIL() << "the light outside should leak";
    } catch (const map::LeakError& leak) {
        EXPECT_NE(std::string(leak.what()).find("light at 400 0 0"), std::string::npos) << leak.what();
    }
}

TEST(Leak, ThePathLeadsThroughTheHole) {
    const std::string closed = room({0, 0, 0}, {256, 256, 128});
    const std::string open = closed.substr(0, closed.rfind("{"));  // without the wall at y = 256
    try {
        compile(level(open, entity_at("info_player_start", {128, 128, 32})), {true});
        FAIL() << "a room of five walls should leak";
    } catch (const map::LeakError& leak) {
        ASSERT_GE(leak.path.size(), 2u);
        EXPECT_EQ(leak.path.front(), (Point{128, 128, 32}));
        EXPECT_GT(leak.path.back().y, 256);
        EXPECT_EQ(map::points_text({{1, 2.5, -3}, {4, 5, 6}}), "1 2.5 -3\n4 5 6");
    }
    EXPECT_NO_THROW(compile(level(closed, entity_at("info_player_start", {128, 128, 32})), {true}));
}

}  // namespace
}  // namespace oblong::test

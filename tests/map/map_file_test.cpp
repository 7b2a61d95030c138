#include <gtest/gtest.h>

#include <algorithm>

#include "tests/map/map_source.h"

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
    expect_complaint(std::string(kHead) + "// a remark\n;", "line 4: found ';', expected a key in quotes");
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
    EXPECT_EQ(bytes_of("\xef\xbb\xbf" + plain), bytes) << "a byte order mark";
    EXPECT_EQ(bytes_of("// Game: Quake\n// Format: Standard\n// entity 0\n" + plain), bytes);
    EXPECT_EQ(bytes_of(replaced(plain, "( 0 ", "(\t0.000 ")), bytes) << "tabs and decimals";
    EXPECT_EQ(bytes_of(replaced(plain, " 0 0 0 1 1\n", " 0 0 0 1 1 0 0 0\n")), bytes) << "Quake 2's three numbers";
    EXPECT_EQ(bytes_of(level(plain_room() + box({100, 0, 0}, {108, 256, 128}, "hint"), lights_of_plain_room())), bytes);
}

}  // namespace
}  // namespace oblong::test

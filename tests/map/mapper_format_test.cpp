#include <gtest/gtest.h>

#include "tests/map/bsp_checks.h"
#include "tests/map/mapper_source.h"

namespace oblong::test {
namespace {

std::string bytes_of(const std::string& source) {
    return map::to_bytes(compile(source, {true}));
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + by.size()))
        text.replace(at, part.size(), by);
    return text;
}

std::string complaint_of(const std::string& source) {
    try {
        compile(source, {true});
    } catch (const InputError& error) {
        return error.where + ": " + error.what();
    }
    return "none";
}

const std::string kLights = entity_at("info_player_start", {64, 64, 40}) + entity_at("light", {128, 128, 100});

std::string plain_room() {
    return room({0, 0, 0}, {256, 256, 128});
}

// A room whose north wall leaves a gap from x = 128 on.
std::string room_with_gap(double gap) {
    const std::string begins_at_minus_1 = box({-1, 256, 0}, {272, 272, 128});
    const std::string east = replaced(begins_at_minus_1, "( -1 ", "( " + std::to_string(128 + gap) + " ");
    return box({-16, -16, -16}, {272, 272, 0}) + box({-16, -16, 128}, {272, 272, 144}) +
           box({-16, 0, 0}, {0, 256, 128}) + box({256, 0, 0}, {272, 256, 128}) + box({-16, -16, 0}, {272, 0, 128}) +
           box({-16, 256, 0}, {128, 272, 128}) + east;
}

TEST(MapperFormat, WhatEditorsAddChangesNothing) {
    const std::string plain = level(plain_room(), kLights), bytes = bytes_of(plain);
    EXPECT_EQ(bytes_of(replaced(plain, "\n", "\r\n")), bytes) << "line ends of DOS";
    EXPECT_EQ(bytes_of("\xef\xbb\xbf" + plain), bytes) << "a byte order mark";
    EXPECT_EQ(bytes_of("// Game: Quake\n// Format: Standard\n// entity 0\n" + plain), bytes);
    EXPECT_EQ(bytes_of(replaced(plain, "( 0 ", "(\t0.000 ")), bytes) << "tabs and decimals";
    EXPECT_EQ(bytes_of(replaced(plain, " 0 0 0 1 1\n", " 0 0 0 1 1 0 0 0\n")), bytes) << "Quake 2's three numbers";
    EXPECT_EQ(bytes_of(level(plain_room() + box({100, 0, 0}, {108, 256, 128}, "hint"), kLights)), bytes);
}

TEST(MapperFormat, SidesSaidTwiceOrOutOfReachChangeNothing) {
    const std::string cube = box({96, 96, 0}, {128, 128, 64});
    const std::string first_side = cube.substr(2, cube.find('\n', 2) - 1);
    const std::string beyond = "( 900 0 0 ) ( 900 0 16 ) ( 900 16 0 ) wall 0 0 0 1 1\n";
    const auto with = [&](const std::string& sides) {
        return bytes_of(level(plain_room() + "{\n" + sides + cube.substr(2), kLights));
    };
    EXPECT_EQ(with(first_side), with(""));
    EXPECT_EQ(compile(level(plain_room() + "{\n" + beyond + cube.substr(2), kLights)).faces.size(),
              compile(level(plain_room() + cube, kLights)).faces.size());
}

TEST(MapperFormat, ErrorsSayWhatIsWrong) {
    const auto says = [](const std::string& source, const std::string& part) {
        EXPECT_NE(complaint_of(source).find(part), std::string::npos) << complaint_of(source);
    };
    says(level("", kLights), "the world has no brushes");
    says(level(plain_room().substr(0, plain_room().rfind('{'))), "the level encloses no space");
    says(level(box({0, 0, 0}, {64, 64, 64})), "the level encloses no space");
    says(level(plain_room(), kLights + entity_at("light", {500, 500, 500})),
         "light at 500 500 500 is open to the void");
    says(level(replaced(plain_room(), "0 0 0 1 1", "0 0 0 0.0001 0.0001"), kLights), "more than 65535 faces");
    says(level(plain_room() + box({100, 100, 50}, {100, 101, 51}), kLights), "lie on one line");
    const std::string cube = box({100, 100, 50}, {110, 110, 60});
    says(level(plain_room() + "{\n" + cube.substr(cube.find('\n', 2) + 1), kLights), "expected a closed convex solid");
}

TEST(MapperFormat, GapsLeakUnlessTheyAreRounding) {
    for (const double gap : {8.0, 1.0, 0.25, 0.05}) {
        const std::string source = level(room_with_gap(gap), kLights);
        EXPECT_THROW(compile(source, {true}), map::LeakError) << gap;
    }
    for (const double gap : {0.01, 0.001, 0.0001, 0.0}) {
        const auto bsp = compile(level(room_with_gap(gap), kLights), {true});
        EXPECT_EQ(first_fault_of_rays(bsp, 1000, 5), "") << gap;
    }
}

TEST(MapperFormat, GroupsAloneAreAWorld) {
    const std::string bytes = bytes_of(level(plain_room(), kLights));
    EXPECT_EQ(bytes_of(level("", entity("func_group", {{"_tb_type", "_tb_group"}}, plain_room()) + kLights)), bytes);
}

}  // namespace
}  // namespace oblong::test

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

int floor_light(const map::BspFile& bsp, int x, int y, std::size_t style = 0) {
    const int light = light_at(bsp, kFloor, {x + 0.0, y + 0.0, 0}, style);
    EXPECT_GE(light, 0) << "no floor at " << x << ' ' << y;
    return light;
}

std::string hall() {
    return room({0, 0, 0}, {224, 224, 128});
}

constexpr Whole kLamp{64, 64, 97};  // 96 over the points of the floor, which are lifted by 1

std::string lamp(const std::vector<std::array<std::string, 2>>& keys = {}) {
    return entity_at("light", kLamp, keys);
}

// The hall, compiled fast.
map::BspFile lit_hall(const std::string& entities, const std::string& brushes = "") {
    return compile(level(hall() + brushes, entities), {true});
}

double distance_to(int x, int y) {
    return std::hypot(x - 64, y - 64, 96);
}

// Of a lamp of 300: light(d) times (1 + cos) / 2, halved.
int expected(double light, int x, int y) {
    return static_cast<int>(light * (1 + 96 / distance_to(x, y)) / 2 / 2);
}

TEST(Lightmaps, FadesAsTheFormulaSays) {
    const auto linear = lit_hall(lamp({{"wait", "-1"}}));  // as with 1
    const auto inverse = lit_hall(lamp({{"delay", "1"}}));
    const auto square = lit_hall(lamp({{"delay", "2"}, {"wait", "2"}}));
    const auto even = lit_hall(lamp({{"delay", "3"}}));
    const auto late = lit_hall(lamp({{"delay", "5"}}));
    for (const auto& [x, y] : {std::pair{64, 64}, {96, 64}, {160, 128}, {192, 192}}) {
        const double d = distance_to(x, y);
        EXPECT_NEAR(floor_light(linear, x, y), expected(300 - d, x, y), 1) << x << ' ' << y;
        EXPECT_NEAR(floor_light(inverse, x, y), expected(300 * 128 / d, x, y), 1) << x << ' ' << y;
        EXPECT_NEAR(floor_light(square, x, y), expected(300 * 64 * 64 / d / d, x, y), 1) << x << ' ' << y;
        EXPECT_NEAR(floor_light(even, x, y), expected(300, x, y), 1) << x << ' ' << y;
        const double faded = (d + 128) / 128;
        EXPECT_NEAR(floor_light(late, x, y), expected(300 / faded / faded, x, y), 1) << "from 128 units before";
    }
}

TEST(Lightmaps, NegativeLightsTakeLightAway) {
    const auto bsp = lit_hall(lamp({{"light", "400"}}) + lamp({{"light", "-250"}}));
    for (const auto& [x, y] : {std::pair{64, 64}, {96, 64}, {160, 128}, {192, 192}}) {
        const double d = distance_to(x, y);
        EXPECT_NEAR(floor_light(bsp, x, y), expected(400 - d - std::max(250 - d, 0.0), x, y), 1) << x << ' ' << y;
    }
    const auto dark = lit_hall(lamp({{"light", "250"}}) + lamp({{"light", "-400"}}));
    EXPECT_EQ(floor_light(dark, 96, 64), 0) << "no darker than dark";
}

TEST(Lightmaps, BrightnessStandsBehindTheColour) {
    const auto light_of = [](const std::string& key, const std::string& value) {
        return floor_light(lit_hall(lamp({{key, value}})), 96, 64);
    };
    EXPECT_EQ(light_of("_light", "255 255 255 220"), light_of("light", "220"));
    EXPECT_EQ(light_of("_light", "1 1 1"), light_of("light", "300")) << "a colour alone";
    EXPECT_NE(light_of("light", "255"), light_of("light", "220"));
}

TEST(Lightmaps, LeastLightOfAModelIsItsOwn) {
    const auto bsp = compile(entity("worldspawn", {{"_minlight", "20"}}, hall()) +
                                 entity("func_wall", {{"_minlight", "60"}}, box({96, 96, 32}, {128, 128, 64})) +
                                 entity("func_wall", {{"_minlight", "10"}}, box({32, 32, 32}, {48, 48, 64})),
                             {true});
    const auto light_of_model = [&](std::size_t model) {
        const auto& face = bsp.faces.at(static_cast<std::size_t>(bsp.models.at(model).first_face));
        return static_cast<int>(bsp.lighting.at(static_cast<std::size_t>(face.light_offset)));
    };
    EXPECT_EQ(light_of_model(0), 10);
    EXPECT_EQ(light_of_model(1), 30);
    EXPECT_EQ(light_of_model(2), 10) << "no less than the world's";
}

// Five styles of one lamp's place: style 3 is the dimmest.
TEST(Lightmaps, OfMoreThanFourStylesTheDimmestGoes) {
    std::string lamps;
    for (const auto& [style, light] : {std::pair{"9", "280"}, {"3", "180"}, {"5", "240"}, {"0", "200"}, {"7", "260"}})
        lamps += lamp({{"style", style}, {"light", light}});
    const auto bsp = lit_hall(lamps);
    const std::array<std::uint8_t, 4> kept{0, 5, 7, 9};
    int full_faces = 0;
    for (const auto& face : bsp.faces) full_faces += face.styles == kept ? 1 : 0;
    EXPECT_GT(full_faces, 0);
    EXPECT_NEAR(floor_light(bsp, 96, 64, 3), expected(280 - distance_to(96, 64), 96, 64), 1) << "style 9";
}

TEST(Lightmaps, APillarThrowsAShadow) {
    for (const bool is_fast : {true, false}) {
        const auto bsp = compile(level(hall() + box({104, 24, 0}, {120, 104, 128}), lamp()), {is_fast});
        EXPECT_EQ(floor_light(bsp, 192, 64), 0) << "behind the pillar";
        EXPECT_GT(floor_light(bsp, 80, 192), 20) << "in the open";
    }
}

// A lamp whose body stands on the floor and its light on top of that, as near as lamps have it.
TEST(Lightmaps, WithinItsRadiusALampsBodyThrowsNoShadow) {
    const std::string body = box({104, 104, 0}, {120, 120, 16});
    const auto lit = [&](const std::vector<std::array<std::string, 2>>& keys) {
        return lit_hall(entity_at("light", {112, 112, 20}, keys), body);
    };
    const auto shaded = lit({}), open = lit({{"radius", "26"}});
    EXPECT_LT(floor_light(shaded, 128, 112), floor_light(shaded, 176, 112)) << "a dark halo";
    int before = 256;
    for (int x = 128; x <= 208; x += 16) {
        EXPECT_LT(floor_light(open, x, 112), before) << x;
        before = floor_light(open, x, 112);
        const double distance = std::hypot(x - 112, 19);
        EXPECT_NEAR(before, (300 - distance) * (1 + 19 / distance) / 2 / 2, 1) << x;
    }
}

TEST(Lightmaps, ALampsRadiusLetsNoLightThroughWhatIsFarther) {
    const auto bsp = lit_hall(lamp({{"radius", "26"}}), box({104, 24, 0}, {120, 104, 128}));
    EXPECT_EQ(floor_light(bsp, 192, 64), 0) << "behind the pillar";
}

// The wall's lower edge, 40 units from the lamp and 33 below it, ends the light where the floor is 96 below: each
// sample is the mean of 16 points, of which those before that line are lit.
TEST(Lightmaps, ManyRaysSoftenTheEdgeOfAShadow) {
    const std::string source = level(hall() + box({104, 24, 64}, {120, 224, 128}), lamp());
    const auto hard = compile(source, {true}), soft = compile(source);
    const double last_lit = 64 + 40 * 96 / 33.0;
    for (int x = 128; x <= 208; x += 16) {
        double sum = 0;
        for (const int dx : {-6, -2, 2, 6})
            for (const int dy : {-6, -2, 2, 6}) {
                const double d = distance_to(x + dx, 128 + dy);
                sum += x + dx < last_lit ? (300 - d) * (1 + 96 / d) / 4 : 0;
            }
        EXPECT_NEAR(floor_light(soft, x, 128), sum / 16, 1) << x;
        EXPECT_NEAR(floor_light(hard, x, 128), x < last_lit ? expected(300 - distance_to(x, 128), x, 128) : 0, 1) << x;
    }
}

TEST(Lightmaps, StylesHaveLightmapsOfTheirOwn) {
    const auto bsp = lit_hall(lamp() + lamp({{"style", "2"}, {"light", "200"}}));
    EXPECT_NEAR(floor_light(bsp, 96, 64, 0), expected(300 - distance_to(96, 64), 96, 64), 1);
    EXPECT_NEAR(floor_light(bsp, 96, 64, 1), expected(200 - distance_to(96, 64), 96, 64), 1);
    for (const auto& face : bsp.faces) EXPECT_EQ(face.styles[1] == 255 || face.styles[1] == 2, true);
    const auto dim = lit_hall(lamp() + lamp({{"style", "2"}, {"delay", "3"}, {"light", "5"}}));
    EXPECT_NEAR(floor_light(dim, 64, 64, 1), expected(5, 64, 64), 1) << "a shade that can be seen";
}

TEST(Lightmaps, ASpotlightLightsItsConeOnly) {
    const auto bsp = lit_hall(lamp({{"target", "spot"}, {"angle", "60"}}) +
                              entity_at("info_null", {64, 64, 0}, {{"targetname", "spot"}}));
    EXPECT_GT(floor_light(bsp, 112, 64), 0) << "26.6 degrees off the axis";
    EXPECT_EQ(floor_light(bsp, 128, 64), 0) << "33.7 degrees off the axis";
}

TEST(Lightmaps, TheSunShinesThroughTheSky) {
    const std::string roofed = hall() + box({0, 0, 96}, {112, 224, 128}, "sky");
    const auto bsp = compile(entity("worldspawn", {{"_sunlight", "200"}, {"_sun_mangle", "0 -90 0"}}, roofed), {true});
    EXPECT_EQ(floor_light(bsp, 64, 64), 100) << "straight down: half of 200";
    EXPECT_EQ(floor_light(bsp, 160, 64), 0) << "under the ceiling";
}

// As in id's own compiler: e1m5 has lamps in and above its skies.
TEST(Lightmaps, ASkyStopsNoLamp) {
    for (const int z : {97, 113}) {
        const std::string below = hall() + box({0, 0, 92}, {224, 224, 104}, "sky");
        const auto linear = compile(level(below, entity_at("light", {64, 64, z})), {true});
        const auto inverse = compile(level(below, entity_at("light", {64, 64, z}, {{"delay", "1"}})), {true});
        for (const auto& [x, y] : {std::pair{64, 64}, {96, 64}, {160, 128}}) {
            const double d = std::hypot(x - 64, y - 64, z - 1), half = (1 + (z - 1) / d) / 2 / 2;
            EXPECT_NEAR(floor_light(linear, x, y), (300 - d) * half, 1) << x << ' ' << y << ", lamp at " << z;
            EXPECT_NEAR(floor_light(inverse, x, y), 300 * 128 / d * half, 1) << x << ' ' << y << ", lamp at " << z;
        }
    }
    const auto wall = lit_hall(entity_at("light", {64, 64, 113}), box({0, 0, 92}, {224, 224, 104}));
    EXPECT_EQ(floor_light(wall, 64, 64), 0) << "a ceiling does";
}

TEST(Lightmaps, ALightOf0IsTheUsualOne) {
    const auto bsp = lit_hall(entity_at("light_globe", kLamp, {{"light", "0"}}));
    EXPECT_NEAR(floor_light(bsp, 96, 64), expected(300 - distance_to(96, 64), 96, 64), 1);
}

TEST(Lightmaps, WhateverHasALightShines) {
    const auto light_of = [](std::string_view its_class, const std::vector<std::array<std::string, 2>>& pairs) {
        return floor_light(lit_hall(entity_at(its_class, kLamp, pairs)), 96, 64);
    };
    const int full = expected(250 - distance_to(96, 64), 96, 64);
    EXPECT_NEAR(light_of("info_teleport_destination", {{"light", "250"}, {"wait", "9"}, {"angle", "90"}}), full, 1);
    EXPECT_NEAR(light_of("a_class_of_others", {{"light", "250"}}), full, 1);
    EXPECT_EQ(light_of("info_null", {{"light", "0"}}), 0);
    EXPECT_EQ(light_of("misc_lantern", {{"light", "250"}, {"texture", "{bars"}}), 0) << "its light is another";
}

TEST(Lightmaps, ALampJustInAWallIsMovedOutOfIt) {
    for (const int depth : {1, 2}) {
        const std::string source = level(hall(), entity_at("light", {-depth, 64, 97}));
        const auto bsp = compile(source, {true});
        const double d = std::hypot(96 - (2 - depth), 96);
        EXPECT_NEAR(floor_light(bsp, 96, 64), (300 - d) * (1 + 96 / d) / 4, 1) << depth;
        EXPECT_EQ(said_of(source), std::vector<std::string>{});
    }
}

TEST(Lightmaps, ALampDeepInAWallIsNamed) {
    const std::string source = "// a remark\n" + level(hall(), entity_at("light", {-8, 64, 97}));
    const std::vector<std::string> said = said_of(source);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find(
                  ": the light at -8 64 97 is inside a wall and lights nothing, expected an open place within 2 units"),
              std::string::npos)
        << said[0];
    const auto line =
        1 + std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(source.rfind("{")), '\n');
    EXPECT_TRUE(said[0].starts_with("line " + std::to_string(line) + ":")) << said[0];
}

}  // namespace
}  // namespace oblong::test

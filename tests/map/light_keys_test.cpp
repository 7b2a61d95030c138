// Keys of light that mappers of other engines use, each against a closed form or a sum in doubles.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::light_keys_test {
using namespace test;
namespace {

int floor_light(const map::BspFile& bsp, int x, int y) {
    const int light = light_at(bsp, kFloor, {x + 0.0, y + 0.0, 0});
    return std::max(light, 0);  // without a lightmap
}

std::string hall(std::string_view ceiling = "wall") {
    return room({0, 0, 0}, {224, 224, 128}) + box({0, 0, 112}, {224, 224, 128}, ceiling);
}

constexpr Whole kLamp{64, 64, 97};  // 96 over the points of the floor, which are lifted by 1
constexpr double kHeight = 96;

double linear_light(double brightness, double distance) {
    return (brightness - distance) * (1 + kHeight / distance) / 4;
}

map::BspFile lit(const Keys& of_world, const Keys& of_lamp) {
    return compile(entity("worldspawn", of_world, hall()) + entity_at("light", kLamp, of_lamp), {true});
}
map::BspFile under_sky(const Keys& of_world) {
    return compile(entity("worldspawn", of_world, hall("sky")), {true});
}

// A sky all over, a slab over the half beyond x = 104 at heights of 64 to 72, and a sun of `degrees` right above.
map::BspFile under_slab(const char* degrees) {
    const Keys sun{{"_sunlight", "200"}, {"_sun_mangle", "0 -90 0"}, {"_sunlight_penumbra", degrees}};
    return compile(entity("worldspawn", sun, hall("sky") + box({104, 0, 64}, {224, 224, 72})), {});
}

// The share of the sun's disc, as a sum over 200 x 200 points, that is in sight from the mean point of a square of 12
// units around x.
double share_in_sight(double x, double degrees) {
    const double radius = std::tan(degrees * std::numbers::pi / 360);
    int seen = 0, all = 0;
    for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 200; ++i)
            for (int j = 0; j < 200; ++j) {
                const double aside = ((i + 0.5) / 100 - 1) * radius, along = ((j + 0.5) / 100 - 1) * radius;
                if (std::hypot(aside, along) > radius) continue;
                ++all;
                const double at = x - 6 + 4 * k;
                seen += at + aside * (aside > 0 ? 71 : 63) < 104;
            }
    return static_cast<double>(seen) / all;
}

TEST(LightKeys, ASunWithAPenumbraSoftensEdgesByItsDisc) {
    const auto bsp = under_slab("40");
    for (int x = 48; x <= 160; x += 16)
        EXPECT_NEAR(floor_light(bsp, x, 112), 100 * share_in_sight(x, 40), 5) << x << ": sixteen points of the disc";
    EXPECT_EQ(floor_light(bsp, 48, 112), 100) << "104 - 71 tan 20 - 6 = 72";
    EXPECT_EQ(floor_light(bsp, 144, 112), 0) << "104 + 63 tan 20 + 6 = 133";
    EXPECT_EQ(floor_light(under_slab("0"), 112, 112), 0);
    EXPECT_EQ(floor_light(under_slab("0"), 80, 112), 100);
}

TEST(LightKeys, ColoursOfSunAndLeastLightCountByTheirLuminance) {
    const auto light_of = [](const Keys& keys) { return floor_light(under_sky(keys), 64, 64); };
    EXPECT_EQ(light_of({{"_sunlight", "200"}, {"_sun_mangle", "0 -90 0"}, {"_sunlight_color", "255 0 0"}}), 29)
        << "half of 200 * 0.299";
    EXPECT_EQ(light_of({{"_sunlight", "200"}, {"_sun_angle", "0 -90 0"}}), 100) << "another name";
    EXPECT_EQ(light_of({{"_sunlight2", "100"}, {"_sunlight2_color", "0 1 0"}}), light_of({{"_sunlight2", "58.7"}}));
    EXPECT_EQ(light_of({{"_minlight", "100"}, {"_minlight_color", "0 0 1"}}), 5) << "half of 100 * 0.114";
}

using Rgb = std::array<int, 3>;

/// As floor_light(), of each channel: samples have the same places.
Rgb floor_colour(const map::BspFile& bsp, int x, int y) {
    map::BspFile of_channel = bsp;
    Rgb colour{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        for (std::size_t i = 0; i < bsp.lighting.size(); ++i)
            of_channel.lighting[i] = bsp.coloured_lighting.at(3 * i + channel);
        colour[channel] = floor_light(of_channel, x, y);
    }
    return colour;
}

TEST(LightKeys, ColouredLightHasRedGreenAndBlueBesideItsLuminance) {
    const int full = static_cast<int>(linear_light(300, kHeight));
    const auto red = lit({}, {{"light", "300"}, {"_color", "255 0 0"}});
    EXPECT_EQ(floor_colour(red, 64, 64), (Rgb{full, 0, 0}));
    EXPECT_EQ(floor_light(red, 64, 64), static_cast<int>(linear_light(300, kHeight) * 0.299));
    const auto mixed = lit({}, {{"light", "255 128 51 300"}});
    const auto part = [](double of_255) { return static_cast<int>(linear_light(300, kHeight) * of_255 / 255); };
    EXPECT_EQ(floor_colour(mixed, 64, 64), (Rgb{full, part(128), part(51)}));
    for (const Keys& white : {Keys{{"light", "300"}}, Keys{{"light", "300"}, {"_color", "0.7 0.7 0.7"}}})
        EXPECT_TRUE(lit({}, white).coloured_lighting.empty());
    EXPECT_TRUE(under_sky({{"_minlight", "30"},
                           {"_minlight_color", "0.7 0.7 0.7"},
                           {"_sunlight2", "50"},
                           {"_sunlight2_color", "0.3 0.3 0.3"}})
                    .coloured_lighting.empty());
}

TEST(LightKeys, AllOfWorldspawnsLightHasColours) {
    const auto colour_of = [](const Keys& keys) { return floor_colour(under_sky(keys), 64, 64); };
    const Keys sun{{"_sunlight", "200"}, {"_sun_mangle", "0 -90 0"}, {"_sunlight_color", "0 1 0.5"}};
    EXPECT_EQ(colour_of(sun), (Rgb{0, 100, 50}));
    EXPECT_EQ(colour_of({{"_minlight", "100"}, {"_minlight_color", "0 0 255"}}), (Rgb{0, 0, 50}));
    const Rgb sky = colour_of({{"_sunlight2", "100"}, {"_sunlight2_color", "1 0.5 0"}});
    EXPECT_GT(sky[0], 20);
    EXPECT_NEAR(sky[1], sky[0] / 2, 1);
    EXPECT_EQ(sky[2], 0);
}

TEST(LightKeys, BouncedLightHasTheColoursOfLampsAndTextures) {
    Palette palette;
    palette.colours.fill({200, 100, 50});
    map::CompileOptions options{true};
    options.palette = &palette;
    const auto floor_beside_shade = [&](const char* colour, const char* share = "1") {
        // The slab keeps the lamp's own light from half of the floor.
        return compile(entity("worldspawn", {{"_bounce", "1"}, {"_bouncecolorscale", share}},
                              hall() + box({96, 0, 40}, {224, 224, 44})) +
                           entity_at("light", {48, 112, 90}, {{"light", "900"}, {"_color", colour}}),
                       options);
    };
    const Rgb red = floor_colour(floor_beside_shade("255 0 0"), 192, 112),
              violet = floor_colour(floor_beside_shade("255 0 255"), 192, 112);
    EXPECT_GT(red[0], 2);
    EXPECT_EQ(red[1] + red[2], 0);
    EXPECT_EQ(violet[0], red[0]);
    EXPECT_EQ(violet[1], 0);
    EXPECT_NEAR(violet[2], violet[0] / 4, 1) << "its texture reflects 50 of blue for 200 of red";
    const Rgb grey = floor_colour(floor_beside_shade("255 0 255", "0"), 192, 112),
              half = floor_colour(floor_beside_shade("255 0 255", "0.5"), 192, 112);
    EXPECT_EQ(grey[2], grey[0]);
    EXPECT_NEAR(half[0], (grey[0] + violet[0]) / 2.0, 1);
    EXPECT_NEAR(half[2], (grey[2] + violet[2]) / 2.0, 1);
}

TEST(LightKeys, ColoursAreInTheFileAndReadFromIt) {
    const auto bsp = lit({}, {{"light", "300"}, {"_color", "255 90 20"}});
    const std::string bytes = map::to_bytes(bsp);
    EXPECT_EQ(map::from_bytes(bytes).coloured_lighting, bsp.coloured_lighting);
    const Level level = engine_level(bytes);
    ASSERT_EQ(level.coloured_lighting.size(), bsp.coloured_lighting.size());
    EXPECT_TRUE(std::equal(level.coloured_lighting.begin(), level.coloured_lighting.end(),
                           bsp.coloured_lighting.begin(),
                           [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); }));
}

TEST(LightKeys, AGroupHasALeastLightOfItsOwn) {
    const auto bsp = compile(entity("worldspawn", {{"_minlight", "20"}}, hall()) +
                                 entity("func_group", {{"_minlight", "60"}}, box({96, 96, 0}, {128, 128, 32})) +
                                 entity("func_detail", {{"_minlight", "10"}}, box({32, 32, 0}, {64, 64, 32})),
                             {true});
    EXPECT_EQ(floor_light(bsp, 192, 192), 10);
    const test::FacingPlane top{{0, 0, 1}, 32};
    EXPECT_EQ(light_at(bsp, top, {112, 112, 32}), 30);
    EXPECT_EQ(light_at(bsp, top, {48, 48, 32}), 10) << "no less than the world's";
}

TEST(LightKeys, WhatIgnoresLightHasTheLeastAlone) {
    const auto bsp = compile(
        entity("worldspawn", {{"_minlight", "20"}, {"_bounce", "1"}, {"_sunlight2", "50"}}, hall("sky")) +
            entity("func_group", {{"_lightignore", "1"}}, box({96, 96, 0}, {128, 128, 32})) + entity_at("light", kLamp),
        {true});
    EXPECT_EQ(light_at(bsp, {{0, 0, 1}, 32}, {112, 112, 32}), 10);
    EXPECT_GT(floor_light(bsp, 64, 64), 60);
}

// The lamp's shadow of a plate at a height of 49 to 53; and a plate above the sky, in a room of its own.
TEST(LightKeys, ABrushEntityThrowsAShadowIfItIsAskedTo) {
    const auto bsp_with = [](const char* shadow) {
        const std::string above = room({0, 0, 160}, {224, 224, 224});
        const Keys sun{{"_sunlight", "100"}, {"_sun_mangle", "0 -90 0"}};
        return compile(entity("worldspawn", sun, hall("sky") + above) +
                           entity("func_wall", {{"_shadow", shadow}}, box({104, 104, 49}, {136, 136, 53})) +
                           entity("func_wall", {{"_shadow", shadow}}, box({16, 16, 180}, {208, 208, 190})) +
                           entity_at("light", kLamp) + entity_at("info_null", {112, 112, 200}),
                       {true});
    };
    const auto without = bsp_with("0"), with = bsp_with("1");
    const double at_192 = linear_light(300, std::hypot(128, 128, kHeight));
    EXPECT_NEAR(floor_light(without, 192, 192), 50 + at_192, 1);
    EXPECT_NEAR(floor_light(with, 192, 192), 50, 1) << "the ray from the lamp is at 128 at its half";
    EXPECT_NEAR(floor_light(without, 112, 112), 50 + linear_light(300, std::hypot(48, 48, kHeight)), 1);
    EXPECT_NEAR(floor_light(with, 112, 112), linear_light(300, std::hypot(48, 48, kHeight)), 1) << "no sun there";
    EXPECT_NEAR(floor_light(with, 32, 192), floor_light(without, 32, 192), 0)
        << "what is behind the sky shades nothing";
    EXPECT_NEAR(light_at(with, {{0, 0, 1}, 53}, {112, 112, 53}), light_at(without, {{0, 0, 1}, 53}, {112, 112, 53}), 0)
        << "nor itself";
}

TEST(LightKeys, DirtSparesWhatItIsToldTo) {
    const auto corner_with = [](const Keys& of_world, const Keys& of_group) {
        const auto bsp =
            compile(entity("worldspawn", of_world, room({0, 0, 0}, {224, 224, 128})) +
                        entity("func_group", of_group, box({96, 96, 0}, {128, 128, 32})) + entity_at("light", kLamp),
                    {true});
        return std::pair(light_at(bsp, {{0, 0, 1}, 32}, {112, 112, 32}), floor_light(bsp, 208, 208));
    };
    const auto plain = corner_with({}, {}), dirty = corner_with({{"_dirt", "1"}}, {}),
               spared = corner_with({{"_dirt", "1"}}, {{"_dirt", "-1"}});
    EXPECT_LT(dirty.first, plain.first);
    EXPECT_EQ(spared.first, plain.first);
    EXPECT_EQ(spared.second, dirty.second);
}

// At 26.6 degrees off the axis, between half cones of 20 and 30.
TEST(LightKeys, ASpotlightFadesFromItsSoftAngleOn) {
    const auto light_with = [](const Keys& keys) {
        Keys all{{"mangle", "0 -90 0"}, {"angle", "60"}};
        all.insert(all.end(), keys.begin(), keys.end());
        return floor_light(lit({}, all), 112, 64);
    };
    const auto cosine = [](double degrees) { return std::cos(degrees * std::numbers::pi / 180); };
    const double at = kHeight / std::hypot(48, kHeight), full = linear_light(300, std::hypot(48, kHeight));
    EXPECT_NEAR(light_with({}), full, 1);
    EXPECT_NEAR(light_with({{"_softangle", "40"}}), full * (at - cosine(30)) / (cosine(20) - cosine(30)), 1);
    EXPECT_NEAR(light_with({{"_softangle", "90"}}), full, 1) << "wider than its cone";
}

// A lamp 96 above and 48 beside a point of the floor; a sun from 45 degrees; the whole hemisphere of a sky.
TEST(LightKeys, TheAngleCountsAsMuchAsItIsTold) {
    const auto lamp_light = [](const Keys& of_world, const Keys& of_lamp) {
        return floor_light(lit(of_world, of_lamp), 112, 64);
    };
    const double distance = std::hypot(48, kHeight), cosine = kHeight / distance;
    const auto lamp = [&](double share) { return (300 - distance) * (1 - share + share * cosine) / 2; };
    EXPECT_NEAR(lamp_light({}, {}), lamp(0.5), 1);
    for (const char* key : {"_anglescale", "_anglesense"}) {
        EXPECT_NEAR(lamp_light({}, {{key, "1"}}), lamp(1), 1);
        EXPECT_NEAR(lamp_light({{key, "0"}}, {}), lamp(0), 1);
        EXPECT_NEAR(lamp_light({{key, "0"}}, {{key, "0.8"}}), lamp(0.8), 1) << "its own comes first";
    }
    EXPECT_NEAR(lamp_light({}, {{"_anglescale", "7"}}), lamp(0.5), 1);
    const auto sky_light = [](const char* key, const char* share) {
        return floor_light(under_sky({{key, "200"}, {"_sun_mangle", "0 -45 0"}, {"_anglescale", share}}), 192, 112);
    };
    EXPECT_NEAR(sky_light("_sunlight", "0"), 100, 1);
    EXPECT_NEAR(sky_light("_sunlight", "0.5"), 50 + 50 * std::sqrt(0.5), 1);
    EXPECT_NEAR(sky_light("_sunlight", "1"), 100 * std::sqrt(0.5), 1);
    EXPECT_NEAR(sky_light("_sunlight2", "0"), sky_light("_sunlight2", "1") * 2, 2) << "the mean cosine is a half";
}

// As a sum over the ball's surface in rings.
TEST(LightKeys, ADeviantLampShinesFromABall) {
    const auto bsp = compile(level(hall() + box({104, 24, 64}, {120, 224, 112}),
                                   entity_at("light", {64, 64, 65}, {{"_deviance", "24"}, {"_samples", "64"}})),
                             {true});
    for (int x = 48; x <= 208; x += 32) {
        double sum = 0;
        for (int i = 0; i < 100; ++i)
            for (int k = 0; k < 100; ++k) {
                const double height = (i + 0.5) / 50 - 1, ring = std::sqrt(1 - height * height);
                const double angle = k * std::numbers::pi / 50;
                const double lamp_x = 64 + 24 * ring * std::cos(angle), lamp_y = 64 + 24 * ring * std::sin(angle),
                             lamp_z = 65 + 24 * height, up = lamp_z - 1;
                const double distance = std::hypot(std::hypot(x - lamp_x, 128 - lamp_y), up);
                // Shut where the ray is in the beam, 64 and more above the floor.
                const double low = x > 104 ? lamp_x + (104 - lamp_x) * 1.0 : 0;
                const double share = x > 104 ? (low - lamp_x) / (x - lamp_x) : 0;
                if (x > 104 && lamp_z - up * share > 64) continue;
                sum += (300 - distance) * (1 + up / distance) / 4;
            }
        EXPECT_NEAR(floor_light(bsp, x, 128), sum / 10'000, 4) << x;
    }
}

// A step's top meets the side of the next one: one round surface only within a group.
TEST(LightKeys, SmoothingStaysWithinItsGroup) {
    const auto top_light = [](const Keys& first, const Keys& second) {
        const auto bsp = compile(level(hall(), entity("func_detail", first, box({64, 64, 0}, {128, 128, 32})) +
                                                   entity("func_detail", second, box({128, 64, 0}, {160, 128, 64})) +
                                                   entity_at("light", kLamp)),
                                 {true});
        return light_at(bsp, {{0, 0, 1}, 32}, {112, 96, 32});
    };
    const auto in_group = [](const char* group) { return Keys{{"_phong_angle", "120"}, {"_phong_group", group}}; };
    const int alone = top_light(in_group("1"), {});
    EXPECT_NE(top_light(in_group("1"), in_group("1")), alone);
    EXPECT_EQ(top_light(in_group("1"), in_group("2")), alone);
}

}  // namespace
}  // namespace oblong::light_keys_test

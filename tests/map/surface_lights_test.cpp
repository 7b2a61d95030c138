#include <gtest/gtest.h>

#include <algorithm>

#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

// A hall, `size` wide and 128 high, of whose ceiling a square in the middle, `width` wide, has the texture "other".
std::string hall_with_panel(int size, int width) {
    const int low = (size - width) / 2, high = (size + width) / 2;
    std::string brushes;
    for (const auto& [mins, maxs] : {std::pair<Whole, Whole>{{0, 0, -16}, {size, size, 0}},
                                     {{-16, 0, 0}, {0, size, 128}},
                                     {{size, 0, 0}, {size + 16, size, 128}},
                                     {{0, -16, 0}, {size, 0, 128}},
                                     {{0, size, 0}, {size, size + 16, 128}},
                                     {{0, 0, 128}, {low, size, 144}},
                                     {{high, 0, 128}, {size, size, 144}},
                                     {{low, 0, 128}, {high, low, 144}},
                                     {{low, high, 128}, {high, size, 144}}})
        brushes += box(mins, maxs);
    return brushes + box({low, low, 128}, {high, high, 144}, "other");
}

// Compiled fast, with these lights.
map::BspFile lit_by(int size, int width, const std::string& lights) {
    return compile(level(hall_with_panel(size, width), lights), {.is_fast = true});
}

void expect_same_light(const map::BspFile& found, const map::BspFile& expected, double y) {
    for (const double x : {32, 96, 128, 208})
        EXPECT_EQ(light_at(found, kFloor, {x, y, 0}), light_at(expected, kFloor, {x, y, 0})) << x << ' ' << y;
}

// Large faces are lit in pieces: 192 x 192 units by four lamps over the middles of their quarters. As a spotlight of
// 180 degrees each lights all before its face.
TEST(SurfaceLights, OfLargeFacesAreCutIntoPieces) {
    std::string lamps;
    for (const int x : {208, 304})
        for (const int y : {208, 304}) lamps += entity_at("light", {x, y, 120}, {{"light", "160"}});
    const auto by_hand = lit_by(512, 192, lamps);
    const std::string spread_light =
        entities_of("light 16 16 16 light=160 _surface=other _surface_offset=8 _surface_spotlight=1 angle=180");
    const auto spread = lit_by(512, 192, spread_light);
    EXPECT_GT(light_at(by_hand, kFloor, {208, 208, 0}), 15);
    expect_same_light(spread, by_hand, 192);
}

TEST(SurfaceLights, AreSpotlightsOfTheUsualAngle) {
    const auto bsp = lit_by(512, 96, entities_of("light 16 16 16 light=300 _surface=other _surface_spotlight=1"));
    EXPECT_GT(light_at(bsp, kFloor, {256, 256, 0}), 60);
    EXPECT_EQ(light_at(bsp, kFloor, {256, 336, 0}), 0) << "40 degrees: 46 units to each side on the floor";
}

std::size_t faces_with(const map::BspFile& bsp, const std::string& texture) {
    return static_cast<std::size_t>(std::count_if(bsp.faces.begin(), bsp.faces.end(), [&](const auto& face) {
        const auto& texinfo = bsp.texinfos.at(static_cast<std::size_t>(face.texinfo));
        return bsp.textures.at(static_cast<std::size_t>(texinfo.texture)).starts_with(texture);
    }));
}

// Each lamp is at the middle of a part of the panel, 2 units before it, and shines as one put there by hand. A pillar's
// sides cut the ceiling's panel in several faces, and so does the limit of 240 texels: the lamps are those of the whole
// panel, each with all of the light.
TEST(SurfaceLights, ShineFromTheMiddlesHoweverTheCompilerCutsTheirFaces) {
    struct Case {
        int size, width;
        std::vector<int> lamps;  // along both axes
    };
    for (const auto& [size, width, lamps] : {Case{256, 64, {128}}, Case{512, 256, {192, 320}}}) {
        // Four texels a unit: 64 units are more than a face may have.
        const std::string hall = replaced(hall_with_panel(size, width), "other 0 0 0 1 1", "other 0 0 0 0.25 0.25");
        const auto lit = [&](const std::string& lights) { return compile(level(hall, lights), {.is_fast = true}); };
        std::string by_hand;
        for (const int x : lamps)
            for (const int y : lamps) by_hand += entity_at("light", {x, y, 126}, {{"light", "200"}});
        const auto expected = lit(by_hand);
        const auto spread = lit(entities_of("light 32 32 16 light=200 _surface=OTHER"));
        EXPECT_GT(faces_with(spread, "other"), 1u) << size;
        EXPECT_GT(light_at(expected, kFloor, {lamps[0] + 0.0, lamps[0] + 0.0, 0}), 30);
        expect_same_light(spread, expected, 160);
        const auto none = lit(entities_of("light 16 16 16 _surface=floor"));
        EXPECT_LE(light_at(none, kFloor, {16, 16, 0}), 0) << "no face has it";
    }
}

// A brush over the floor plan with these corners, counter-clockwise seen from above.
std::string upright(const std::vector<std::array<int, 2>>& corners, int low, int high, std::string_view texture) {
    const auto at = [&](std::size_t i, int z) {
        return Whole{corners[i % corners.size()][0], corners[i % corners.size()][1], z};
    };
    std::vector<std::array<Whole, 3>> sides{{at(0, high), at(2, high), at(1, high)},
                                            {at(0, low), at(1, low), at(2, low)}};
    for (std::size_t i = 0; i < corners.size(); ++i) sides.push_back({at(i + 1, low), at(i, low), at(i, high)});
    return brush(sides, texture);
}

// A trapezoid is a square of 96 less a triangle of 48 x 96: its centre of gravity by those of both.
TEST(SurfaceLights, StandAtTheCentreOfGravity) {
    const std::string hall = replaced(hall_with_panel(256, 96), box({80, 80, 128}, {176, 176, 144}, "other"), "") +
                             upright({{80, 80}, {176, 80}, {176, 176}, {128, 176}}, 128, 144, "other") +
                             upright({{80, 80}, {128, 176}, {80, 176}}, 128, 144, "wall");
    const auto bsp_of = [&](const std::string& light) { return compile(level(hall, light), {.is_fast = true}); };
    const double area = 96 * 96 - 48 * 96 / 2.0;
    const double x = 80 + (96 * 96 * 48 - 48 * 96 / 2.0 * 16) / area,
                 y = 80 + (96 * 96 * 48 - 48 * 96 / 2.0 * 64) / area;
    const auto by_hand = bsp_of(entity(
        "light", {{"origin", std::to_string(x) + " " + std::to_string(y) + " 126"}, {"light", "250"}, {"delay", "2"}}));
    const auto spread = bsp_of(entities_of("light 16 16 16 light=250 delay=2 _surface=other"));
    for (const int place_x : {96, 128, 144, 160})
        for (const int place_y : {96, 128, 160}) {
            const Point place{place_x + 0.0, place_y + 0.0, 0};
            EXPECT_GT(light_at(by_hand, kFloor, place), 60);
            EXPECT_NEAR(light_at(spread, kFloor, place), light_at(by_hand, kFloor, place), 1)
                << place_x << ' ' << place_y;
        }
}

// A panel around a hole: its middle is in the hole, where no lamp belongs.
TEST(SurfaceLights, StandBeforeAFaceWhereThePanelHasAHole) {
    const std::string start = entity_at("info_player_start", {32, 32, 28});
    const auto bsp = compile(level(hall_with_panel(256, 96) + box({112, 112, 100}, {144, 144, 128}),
                                   start + entities_of("light 16 16 16 light=250 _surface=other")),
                             {.is_fast = true});
    int brightest = 0;
    for (const int x : {64, 96, 128, 160, 192})
        for (const int y : {64, 96, 128, 160, 192})
            brightest = std::max(brightest, light_at(bsp, kFloor, {x + 0.0, y + 0.0, 0}));
    EXPECT_NEAR(brightest, 62, 4) << "(250 - 125) / 2: a whole lamp, in the open";
}

// A level has shades, no colours: red, green and blue count 0.299, 0.587 and 0.114 (BT.601). What arrives counts less
// then; the lamp reaches as far.
// It is a pattern: what shines are the faces.
TEST(SurfaceLights, MayBeWrittenDownOutsideOfTheLevel) {
    const auto lit_from = [](const Whole& at) {
        map::BspFile bsp = compile(
            level(plain_room() + box({96, 96, 120}, {128, 128, 128}, "other"),
                  entity_at("info_player_start", {64, 64, 40}) + entity_at("light", at, {{"_surface", "other"}})),
            {true});
        return bsp.lighting;
    };
    EXPECT_FALSE(lit_from({64, 64, 64}).empty());
    EXPECT_EQ(lit_from({-3112, -1776, -680}), lit_from({64, 64, 64}));
    expect_complaint(level(plain_room(), lights_of_plain_room() + entity_at("light", {-3112, 0, 0})),
                     "outside of the level");
}

// Four numbers in "light" are a colour and a brightness, three a colour of the usual one; "_color" has precedence.
TEST(ColouredLight, CountsTheSameInBothKeys) {
    const auto lighting_of = [](const std::vector<std::array<std::string, 2>>& keys) {
        return compile(level(plain_room(), entity_at("light", {128, 128, 100}, keys)), {true}).lighting;
    };
    const auto least_of = [](const std::string& light) {
        return compile(entity("worldspawn", {{"light", light}}, plain_room()), {true}).lighting;
    };
    for (const std::string colour : {"0 0 255", "255 255 255", "1 0.5 0", "0 0 1", "128 64 32"})
        for (const std::string key : {"light", "_light"}) {
            const std::string expected = lighting_of({{"_color", colour}, {"light", "900"}});
            EXPECT_EQ(lighting_of({{key, colour + " 900"}}), expected) << colour;
            EXPECT_EQ(lighting_of({{"_color", colour}, {key, "255 0 255 900"}}), expected) << colour;
            EXPECT_EQ(lighting_of({{key, colour}}), lighting_of({{"_color", colour}})) << colour;
        }
    EXPECT_EQ(least_of("255 255 255 100"), least_of("100"));
    EXPECT_EQ(least_of("0 255 0 100"), least_of("58.7"));
}

TEST(ColouredLight, CountsByItsLuminance) {
    for (const char* delay : {"0", "1", "2", "3", "5"}) {
        const auto light_of = [&](const std::string& colour) {
            const auto bsp = compile(
                level(room({0, 0, 0}, {256, 256, 128}),
                      entity_at("light", {128, 128, 97}, {{"delay", delay}, {"light", "280"}, {"_color", colour}})),
                {.is_fast = true});
            return light_at(bsp, kFloor, {128, 128, 0});
        };
        const int white = light_of("255 255 255");
        EXPECT_GE(white, 40) << delay;
        EXPECT_EQ(light_of("1 1 1"), white);
        EXPECT_NEAR(light_of("255 0 0"), 0.299 * white, 1) << delay;
        EXPECT_NEAR(light_of("0 1 0"), 0.587 * white, 1) << delay;
        EXPECT_NEAR(light_of("0 128 255"), (0.587 * 128 / 255 + 0.114) * white, 1) << delay;
    }
}

}  // namespace
}  // namespace oblong::test

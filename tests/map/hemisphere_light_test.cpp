#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"
#include "tools/map/light/face_sampler.h"

namespace oblong::test {
namespace {

std::string world_with(const std::vector<std::array<std::string, 2>>& pairs, const std::string& brushes) {
    return entity("worldspawn", pairs, brushes);
}

// A light that is the same everywhere: no fading with distance, and the angle makes the only difference.
std::string even_lamp(const Whole& place) {
    return entity_at("light", place, {{"delay", "3"}, {"light", "200"}});
}

// Over a point of an endless floor with a ceiling at height h, Lambert's mean of 1 - d / D is (1 - h / D)^2: the
// integral of (1 - h / (D c)) 2 c over cosines c from h / D to 1.
TEST(HemisphereLight, DirtUnderACeilingIsAsItsIntegralSays) {
    const auto bsp_of = [](const std::string& depth) {
        const std::string hall = room({0, 0, 0}, {1024, 1024, 65});
        return compile(world_with({{"_dirt", "1"}, {"_dirtdepth", depth}}, hall) + even_lamp({512, 512, 60}),
                       {.is_fast = false});
    };
    const int clean = light_at(bsp_of("32"), kFloor, {512, 512, 0});
    EXPECT_GT(clean, 90);
    for (const double depth : {96, 128, 256}) {
        const double dirt = std::pow(1 - 64 / depth, 2);  // samples are 1 unit over the floor
        EXPECT_NEAR(light_at(bsp_of(std::to_string(static_cast<int>(depth))), kFloor, {512, 512, 0}),
                    clean * (1 - dirt), 2)
            << depth;
    }
}

TEST(HemisphereLight, DirtsScaleAndGainAreAFactorAndAnExponent) {
    const auto light_of = [](const std::vector<std::array<std::string, 2>>& pairs) {
        return light_at(compile(world_with(pairs, room({0, 0, 0}, {1024, 1024, 65})) + even_lamp({512, 512, 60})),
                        kFloor, {512, 512, 0});
    };
    const int clean = light_of({});
    EXPECT_NEAR(light_of({{"_dirt", "1"}, {"_dirtscale", "2"}}), clean * (1 - 2 * 0.25), 2);
    EXPECT_NEAR(light_of({{"_dirt", "1"}, {"_dirtgain", "2"}}), clean * (1 - 0.0625), 2);
    EXPECT_NEAR(light_of({{"_dirt", "1"}, {"_bounce", "3"}, {"_bouncescale", "0"}}), clean * (1 - 0.25), 2)
        << "once, however often light bounces";
}

// From the middle of the floor of an endless trench, w wide and h deep, sky is seen to the share
// sin(atan(w / 2h)): Hottel's crossed strings. All of it brings 3/4 of the key.
TEST(HemisphereLight, SkyLightsATrenchByItsOpening) {
    for (const int depth : {64, 128, 256}) {
        const std::string trench = box({0, 0, -16}, {2048, 128, 0}) + box({0, -16, -16}, {2048, 0, depth}) +
                                   box({0, 128, -16}, {2048, 144, depth}) + box({-16, -16, -16}, {0, 144, depth + 16}) +
                                   box({2048, -16, -16}, {2064, 144, depth + 16}) +
                                   box({0, -16, depth}, {2048, 144, depth + 16}, "sky");
        const std::string start = entity_at("info_player_start", {64, 64, 28});
        const auto bsp = compile(world_with({{"_sunlight2", "240"}}, trench) + start);
        const double share = 64 / std::hypot(64, depth - 1);
        EXPECT_NEAR(light_at(bsp, kFloor, {1024, 64, 0}), 90 * share, 3) << depth;
        for (const double x : {976, 992, 1008})  // all nine samples around each are there: all rays
            EXPECT_EQ(light_at(bsp, kFloor, {x, 64, 0}), light_at(bsp, kFloor, {1024, 64, 0})) << depth << ' ' << x;
        EXPECT_LE(light_at(compile(world_with({{"_sunlight3", "240"}}, trench) + start), kFloor, {1024, 64, 0}), 0)
            << "nothing comes from below the horizon";
    }
}

// `light` of ericw-tools 2.0 (65 suns, of which more are high than an even spread has) lights the top of a block by 77
// and its sides by 38 where the key is 200.
TEST(HemisphereLight, SkyAllAroundIsAsBrightAsOthersMakeIt) {
    const std::string open = room({0, 0, 0}, {512, 512, 256}, 16, "sky") + box({0, 0, -16}, {512, 512, 1}) +
                             box({224, 224, 0}, {288, 288, 64});
    const auto bsp = compile(world_with({{"_sunlight2", "200"}}, open) + entity_at("info_player_start", {64, 64, 28}));
    EXPECT_NEAR(light_at(bsp, {{0, 0, 1}, 64}, {256, 256, 64}), 77, 3);
    EXPECT_NEAR(light_at(bsp, {{0, -1, 0}, -224}, {256, 224, 32}), 38, 2);
}

// The same upside down.
TEST(HemisphereLight, SkyBelowLightsFromBelowAsThatAboveFromAbove) {
    const std::string open = room({0, 0, 0}, {512, 512, 256}, 16, "sky") + box({224, 224, 96}, {288, 288, 160});
    const auto bsp = compile(world_with({{"_sunlight3", "200"}}, open) + entity_at("info_player_start", {64, 64, 28}));
    EXPECT_NEAR(light_at(bsp, {{0, 0, -1}, -96}, {256, 256, 96}), 77, 3);
    EXPECT_NEAR(light_at(bsp, {{0, -1, 0}, -224}, {256, 224, 128}), 38, 2);
    EXPECT_LE(light_at(bsp, {{0, 0, 1}, 160}, {256, 256, 160}), 0);
}

// In a closed room where all surfaces have the same light L and give back half of it, the first bounce brings L / 2,
// the second L / 4: whatever the room's shape. A lamp that does not fade lights no face evenly, so that sky all around
// does.
TEST(HemisphereLight, BouncesInAClosedRoomAreAGeometricSeries) {
    const std::string sealed = room({0, 0, 0}, {256, 192, 128}) + box({96, 64, 0}, {160, 96, 64});
    const std::string start = entity_at("info_player_start", {32, 32, 28});
    std::string lamps;
    for (const int z : {16, 64, 112})
        for (const int y : {16, 64, 128, 176})
            for (const int x : {16, 64, 128, 192, 240})
                lamps += entity_at("light", {x, y, z}, {{"delay", "3"}, {"light", "4"}});
    const auto mean_light = [&](const char* bounces, const char* scale) {
        const auto bsp = compile(world_with({{"_bounce", bounces}, {"_bouncescale", scale}}, sealed) + start + lamps);
        double sum = 0;
        for (const char sample : bsp.lighting) sum += static_cast<unsigned char>(sample);
        return sum / static_cast<double>(bsp.lighting.size());
    };
    const double direct = mean_light("0", "1");
    EXPECT_GT(direct, 20);
    EXPECT_NEAR(mean_light("1", "1") / direct, 1.5, 0.06);
    EXPECT_NEAR(mean_light("2", "1") / direct, 1.75, 0.08);
    EXPECT_NEAR(mean_light("1", "0.5") / direct, 1.25, 0.04);
}

std::string hall_with_table() {
    return room({0, 0, 0}, {256, 256, 128}) + box({64, 64, 48}, {192, 192, 56});
}

// A lamp over a table lights the ceiling and what is around it; under the table no light falls but what was bounced.
TEST(HemisphereLight, WhatNoLampReachesIsLitByABounce) {
    const auto bsp_of = [&](bool has_bounce) {
        return compile(level(hall_with_table(), entity_at("light", {128, 128, 96})), {.has_bounce = has_bounce});
    };
    EXPECT_LE(light_at(bsp_of(false), kFloor, {128, 128, 0}), 0);
    EXPECT_GT(light_at(bsp_of(true), kFloor, {128, 128, 0}), 2);
    EXPECT_GE(light_at(bsp_of(true), kFloor, {16, 16, 0}), light_at(bsp_of(false), kFloor, {16, 16, 0}));
}

// The shadow under the table of the test above is all that a bounce of styled light would change.
TEST(HemisphereLight, OnlySteadyLightBounces) {
    const auto lighting_of = [&](const char* style, bool has_bounce) {
        const auto lamp = entity_at("light", {128, 128, 96}, {{"style", style}});
        return compile(level(hall_with_table(), lamp), {.has_bounce = has_bounce}).lighting;
    };
    EXPECT_EQ(lighting_of("5", true), lighting_of("5", false));
    EXPECT_NE(lighting_of("0", true), lighting_of("0", false));
}

// With `_bouncestyled` the light of each lamp is the same, direct and bounced, whatever its style: each style's layer
// is the lightmap of a level that has only that lamp, as a steady one.
TEST(HemisphereLight, StyledLightBouncesInItsOwnLayer) {
    const auto bsp_of = [&](const std::vector<std::pair<int, const char*>>& lamps) {  // x, style
        std::string entities = entity_at("info_player_start", {32, 32, 28});
        for (const auto& [x, style] : lamps) entities += entity_at("light", {x, 96, 96}, {{"style", style}});
        return compile(
            world_with({{"_bounce", "2"}, {"_bouncestyled", "1"}, {"_dirt", "1"}}, hall_with_table()) + entities,
            {.is_fast = true});
    };
    const auto steady_west = bsp_of({{80, "0"}}), steady_east = bsp_of({{176, "0"}});
    const auto both = bsp_of({{80, "0"}, {176, "5"}});
    EXPECT_EQ(bsp_of({{176, "5"}}).lighting, steady_east.lighting);
    ASSERT_EQ(both.faces.size(), steady_west.faces.size());
    const auto layer = [](const map::BspFile& bsp, std::size_t face, int style) {
        const auto& styles = bsp.faces[face].styles;
        const auto at = std::find(styles.begin(), styles.end(), style);
        if (at == styles.end() || bsp.faces[face].light_offset < 0) return std::string();
        const auto [width, height] = map::light_grid(bsp, bsp.faces[face]).count;
        const auto size = as_size(width * height);
        return bsp.lighting.substr(as_size(bsp.faces[face].light_offset) + as_size(at - styles.begin()) * size, size);
    };
    int with_both = 0;
    for (std::size_t face = 0; face < both.faces.size(); ++face) {
        with_both += both.faces[face].styles[1] == 5 ? 1 : 0;
        EXPECT_EQ(layer(both, face, 0), layer(steady_west, face, 0)) << face;
        EXPECT_EQ(layer(both, face, 5), layer(steady_east, face, 0)) << face;
    }
    EXPECT_GE(with_both, 6);
}

// The light of a face between two samples of a row.
double light_between(const map::BspFile& bsp, const map::FileFace& face, const Point& place) {
    const FacingPlane plane = facing_plane(bsp, face);
    const Point along = map::to_point(bsp.texinfos.at(as_size(face.texinfo)).axes[0].direction);
    const double steps = dot(along, place) / 16, share = steps - std::floor(steps);
    return (1 - share) * light_at(bsp, plane, place - along * (16 * share)) +
           share * light_at(bsp, plane, place + along * (16 * (1 - share)));
}

// A round pillar of 12 faces: at the corners the light is that of a cylinder, whose normal points away from the axis.
TEST(SmoothLight, APillarsEdgesAreLitAsACylinder) {
    const std::string pillar = prism({256, 256, 0}, 64, 128, 12);
    const auto bsp_of = [&](const std::vector<std::array<std::string, 2>>& pairs) {
        return compile(level(room({0, 0, 0}, {512, 512, 128}),
                             entity("func_detail", pairs, pillar) + entities_of("light 480 256 64 delay=3 light=400")),
                       {.is_fast = true});
    };
    const auto steps_at_edges = [&](const map::BspFile& bsp) {  // the largest difference across an upright edge
        std::map<std::array<int, 2>, std::vector<double>> by_edge;
        for (const auto& face : bsp.faces) {
            if (std::abs(facing_plane(bsp, face).normal.z) > 0.1 || face.light_offset < 0) continue;
            for (const Point& corner : corners_of(bsp, face)) {
                if (std::hypot(corner.x - 256, corner.y - 256) > 70) continue;
                const double light = light_between(bsp, face, {corner.x, corner.y, 64});
                by_edge[{static_cast<int>(corner.x), static_cast<int>(corner.y)}].push_back(light);
            }
        }
        double most = 0;
        for (const auto& [edge, lights] : by_edge)
            most = std::max(most, *std::max_element(lights.begin(), lights.end()) -
                                      *std::min_element(lights.begin(), lights.end()));
        return most;
    };
    EXPECT_GT(steps_at_edges(bsp_of({})), 20) << "flat faces";
    EXPECT_LT(steps_at_edges(bsp_of({{"_phong", "1"}})), 4);
    EXPECT_GT(steps_at_edges(bsp_of({{"_phong", "1"}, {"_phong_angle", "20"}})), 20) << "edges of 30 degrees stay";
    EXPECT_LT(steps_at_edges(bsp_of({{"_phong_angle", "35"}})), 4);
}

// Where the light ends at an edge of a round pillar, both faces of that edge have the same light: half of their
// samples' points are on either. The lamp is behind the darker face.
TEST(SmoothLight, LightEndsSmoothlyAtAnEdge) {
    const auto bsp = compile(level(room({0, 0, 0}, {512, 512, 128}),
                                   entity("func_detail", {{"_phong", "1"}}, prism({256, 256, 0}, 64, 128, 10)) +
                                       entities_of("light 480 256 64 delay=3 light=400")));
    std::vector<double> lights;
    for (const auto& face : bsp.faces) {
        const auto corners = corners_of(bsp, face);
        if (std::abs(facing_plane(bsp, face).normal.z) < 0.1 &&
            std::any_of(corners.begin(), corners.end(), [](const Point& p) { return p.x == 276 && p.y == 317; }))
            lights.push_back(light_between(bsp, face, {276, 317, 64}));
    }
    ASSERT_EQ(lights.size(), 2U);
    EXPECT_GT(lights[0], 20);
    EXPECT_NEAR(lights[0], lights[1], 5);
}

// At an edge of a square pillar, of just the angle that is smoothed, the normal is the mean of both faces'; between two
// edges it goes linearly from one to the other. The larger floor is cut 16 units beside the middle of the pillar's
// face, which has a corner there.
TEST(SmoothLight, NormalsTurnLinearlyFromEdgeToEdge) {
    for (const int size : {224, 512}) {
        const int middle = size / 2;
        const std::string pillar = box({middle - 32, middle - 32, 0}, {middle + 32, middle + 32, 128});
        const auto bsp =
            compile(level(room({0, 0, 0}, {size, size, 128}),
                          entity("func_detail", {{"_phong_angle", "90"}}, pillar) +
                              entity_at("light", {size - 16, middle, 64}, {{"delay", "3"}, {"light", "400"}})),
                    {.is_fast = true});
        for (const int y : {-32, -16, 0, 16, 32}) {
            const double turn = y / 32.0, east = middle - 16 - 33;
            const double cosine = (east - turn * y) / (std::hypot(1, turn) * std::hypot(east, y));
            EXPECT_NEAR(light_at(bsp, {{1, 0, 0}, middle + 32.0}, {middle + 32.0, middle + y + 0.0, 64}),
                        400 * (1 + cosine) / 4, 1.5)
                << size << ' ' << y;
        }
    }
}

}  // namespace
}  // namespace oblong::test

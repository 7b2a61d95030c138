#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

map::BspFile varied_level() {
    return compile(
        level(room({-256, -256, 0}, {700, 256, 256}) + prism({0, 0, 0}, 60, 256, 9) +
                  box({-256, -256, 0}, {-100, 256, 40}, "*water") + box({300, -64, 0}, {332, 64, 128}, "+0lamp"),
              entity("func_door", {{"angle", "90"}}, box({400, 0, 0}, {416, 64, 96}, "floor")) +
                  entity_at("light", {0, 100, 128})),
        {true});
}

TEST(Emit, TheEnginesReaderTakesIt) {
    const auto bsp = varied_level();
    const Level level = engine_level(bsp);
    EXPECT_EQ(level.faces.size(), bsp.faces.size());
    EXPECT_EQ(level.models.size(), 2u);
    EXPECT_EQ(level.entities[1].value("model"), "*1");
    EXPECT_EQ(level.textures.back().name, "+1lamp") << "the other frame of an animation comes along";
}

TEST(Emit, FacesRunClockwiseOnTheirPlane) {
    const auto bsp = varied_level();
    for (const auto& face : bsp.faces) {
        const auto corners = corners_of(bsp, face);
        const FacingPlane plane = facing_plane(bsp, face);
        Point turn;
        for (std::size_t i = 2; i < corners.size(); ++i)
            turn = turn + cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
        EXPECT_LT(dot(turn, plane.normal), 0);
        for (const Point& corner : corners) EXPECT_NEAR(dot(plane.normal, corner), plane.distance, 0.02);
    }
}

TEST(Emit, PlanesHaveTheirLongestComponentPositive) {
    for (const auto& plane : varied_level().planes) {
        const auto axis = static_cast<std::size_t>(plane.type % 3);
        EXPECT_GT(plane.normal[axis], 0);
        for (const float other : plane.normal) EXPECT_LE(std::abs(other), plane.normal[axis] + 1e-5f);
        EXPECT_EQ(plane.type < 3, plane.normal[axis] == 1.0f);
    }
}

TEST(Emit, FacesOfANodeLieOnItsPlane) {
    const auto bsp = varied_level();
    std::set<int> faces_of_nodes;
    for (const auto& node : bsp.nodes) {
        for (int i = node.first_face; i < node.first_face + node.face_count; ++i) {
            EXPECT_EQ(bsp.faces.at(static_cast<std::size_t>(i)).plane, node.plane);
            EXPECT_TRUE(faces_of_nodes.insert(i).second) << "in one node only";
        }
    }
    EXPECT_EQ(faces_of_nodes.size(), bsp.faces.size());
}

TEST(Emit, AnEdgeIsUsedOnceEachWayAtMost) {
    const auto bsp = varied_level();
    std::map<int, int> uses;
    for (const int edge : bsp.surf_edges) EXPECT_EQ(++uses[edge], 1) << edge;
    EXPECT_EQ(uses.count(0), 0u) << "edge 0 has no other direction";
}

TEST(Emit, LiquidsAreDrawnFromBothSides) {
    const auto bsp = varied_level();
    int up = 0, down = 0;
    for (const auto& face : bsp.faces) {
        const FacingPlane plane = facing_plane(bsp, face);
        if (std::abs(plane.normal.z) == 1 && std::abs(plane.distance) == 40) ++(plane.normal.z > 0 ? up : down);
    }
    EXPECT_GT(up, 0);
    EXPECT_EQ(up, down);
    EXPECT_EQ(contents_at(bsp, 0, 0, {-200, 0, 20}), contents::kWater);
    EXPECT_EQ(contents_at(bsp, 0, 0, {-200, 0, 60}), contents::kEmpty);
    EXPECT_EQ(contents_at(bsp, 0, 1, {-200, 0, 30}), contents::kEmpty) << "liquids stop no one";
}

// A cage of two brushes that touch, one of a lamp inside it: each face outside has one inside with its corners and
// light.
TEST(Emit, ABrushEntityIsDrawnFromInsideIfItIsAskedTo) {
    const auto cage_with = [](const char* mirror) {
        const std::string cage = box({0, 0, 32}, {64, 64, 96}) + box({64, 0, 32}, {128, 64, 96});
        return compile(
            level(room({-256, -256, 0}, {256, 256, 256}),
                  entity("func_illusionary", {{"_mirrorinside", mirror}}, cage) + entity_at("light", {32, 32, 65})),
            {true});
    };
    using Corners = std::set<std::array<double, 3>>;
    const auto faces_of = [](const map::BspFile& bsp, bool is_inside) {
        std::multiset<Corners> found;
        for (int i = 0; i < bsp.models[1].face_count; ++i) {
            const map::FileFace& face = bsp.faces.at(static_cast<std::size_t>(bsp.models[1].first_face + i));
            const FacingPlane plane = facing_plane(bsp, face);
            if ((dot(plane.normal, {64, 32, 64}) > plane.distance) != is_inside) continue;
            Corners corners;
            for (const Point& corner : corners_of(bsp, face)) corners.insert({corner.x, corner.y, corner.z});
            found.insert(corners);
        }
        return found;
    };
    const auto with = cage_with("1"), without = cage_with("0");
    EXPECT_EQ(faces_of(without, false).size(), 6u);
    EXPECT_EQ(faces_of(without, true).size(), 0u);
    EXPECT_EQ(faces_of(with, false), faces_of(without, false));
    EXPECT_EQ(faces_of(with, true), faces_of(with, false));
    const auto fence =
        compile(level(room({-256, -256, 0}, {256, 256, 256}),
                      entity("func_detail_fence", {{"_mirrorinside", "1"}}, box({0, 0, 32}, {64, 64, 96}, "{bars")) +
                          entity_at("light", {32, 32, 65})),
                {true});
    EXPECT_EQ(fence.models[1].face_count, 12) << "as the func_wall that it becomes";
    // The lamp is at a distance of 32 over the floor's samples, which are lifted by 1, and lights no outer face.
    EXPECT_EQ(light_at(with, {{0, 0, 1}, 32}, {32, 32, 32}), (300 - 32) / 2);
    EXPECT_LE(light_at(with, {{0, 0, -1}, -32}, {32, 32, 32}), 0);
}

TEST(Emit, ADoorIsAModelOfItsOwn) {
    const auto bsp = varied_level();
    ASSERT_EQ(bsp.models.size(), 2u);
    const Point inside{408, 32, 48}, beside{424, 32, 48}, far{460, 32, 48};
    EXPECT_EQ(contents_at(bsp, 0, 0, inside), contents::kEmpty) << "the world has a hole there";
    EXPECT_EQ(contents_at(bsp, 1, 0, inside), contents::kSolid);
    EXPECT_EQ(contents_at(bsp, 1, 0, beside), contents::kEmpty);
    EXPECT_EQ(contents_at(bsp, 1, 1, beside), contents::kSolid) << "8 units from it a player of half width 16 overlaps";
    EXPECT_EQ(contents_at(bsp, 1, 1, far), contents::kEmpty);
    EXPECT_EQ(bsp.models[1].face_count, 6);
}

// The door reaches from 400 0 0 to 416 64 96. Files of other compilers say a unit less a side, and engines add it.
TEST(Emit, ModelsAreStoredAUnitSmallerASide) {
    const auto bsp = varied_level();
    EXPECT_EQ(bsp.models[1].mins, (map::Floats{401, 1, 1}));
    EXPECT_EQ(bsp.models[1].maxs, (map::Floats{415, 63, 95}));
    const Level level = engine_level(bsp);
    EXPECT_EQ(level.models[ModelIndex(1)].box.mins, (std::array<std::int32_t, 3>{400, 0, 0}));
    EXPECT_EQ(level.models[ModelIndex(1)].box.maxs, (std::array<std::int32_t, 3>{416, 64, 96}));
}

TEST(Emit, AModelWithoutBrushesIsReadable) {
    const auto bsp = compile(
        level(room({0, 0, 0}, {224, 224, 128}), entity("func_wall", {}, box({64, 64, 0}, {96, 96, 128}, "hint"))),
        {true});
    const Level level = engine_level(bsp);
    EXPECT_EQ(level.models[ModelIndex(1)].faces.count, 0);
}

TEST(Emit, TriggersAndClipBrushesAreNotDrawn) {
    const auto bsp = compile(level(room({0, 0, 0}, {224, 224, 128}) + box({64, 64, 0}, {96, 96, 128}, "clip"),
                                   entity("trigger_multiple", {}, box({128, 128, 0}, {160, 160, 64}, "trigger"))),
                             {true});
    EXPECT_EQ(bsp.models[0].face_count, 6) << "the walls of the room alone";
    EXPECT_EQ(contents_at(bsp, 0, 0, {80, 80, 64}), contents::kEmpty);
    EXPECT_EQ(contents_at(bsp, 0, 1, {80, 80, 64}), contents::kSolid);
    EXPECT_EQ(bsp.models[1].face_count, 0);
    EXPECT_EQ(contents_at(bsp, 1, 1, {144, 144, 32}), contents::kSolid) << "a trigger is touched";
}

}  // namespace
}  // namespace oblong::test

#include "engine/level/t_junctions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace oblong::test {
namespace {

using Place = std::array<int, 3>;  ///< whole units

/// Vertices at different places of a box, each up to 3 steps off in each direction, as those of compilers are. A whole
/// place that is not on the line through two others is at least 37 steps from it, if the box is at most 64 long.
struct Scatter {
    std::vector<Place> places;
    Level level;

    Scatter(std::mt19937& random, std::size_t vertices, std::size_t edges, const Place& size, int origin) {
        const auto below = [&](std::size_t end) { return static_cast<int>(random() % end); };
        std::set<Place> all;
        while (all.size() < vertices) all.insert({below(size[0] + 1u), below(size[1] + 1u), below(size[2] + 1u)});
        places.assign(all.begin(), all.end());
        std::shuffle(places.begin(), places.end(), random);
        for (const Place& place : places) {
            const auto part = [&](int axis) {
                return World::from_raw((item(place, axis) + origin) * 4096 + below(7) - 3);
            };
            const World x = part(0), y = part(1), z = part(2);
            level.vertices.push_back({x, y, z});
        }
        for (std::size_t edge = 0; edge < edges; ++edge)
            level.edges.push_back({VertexIndex(below(vertices)), VertexIndex(below(vertices))});
        // The last edge is no face's.
        for (const EdgeIndex edge : level.edges.indices())
            if (edge.number() + 1 < level.edges.count()) level.surf_edges.push_back({edge, false});
    }

    bool is_used(VertexIndex vertex) const {
        return std::any_of(level.surf_edges.begin(), level.surf_edges.end(), [&](const SurfEdge& step) {
            const Edge& edge = level.edges[step.edge()];
            return edge.from == vertex || edge.to == vertex;
        });
    }

    /// Looks at every vertex, in whole numbers.
    std::vector<VertexIndex> inside(const Edge& edge) const {
        const auto difference = [&](VertexIndex a, VertexIndex b, int axis) {
            return item(places[a.position()], axis) - item(places[b.position()], axis);
        };
        std::vector<std::pair<int, VertexIndex>> found;
        for (const VertexIndex vertex : level.vertices.indices()) {
            int part = 0, length = 0, apart = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const int next = (axis + 1) % 3, along = difference(edge.to, edge.from, axis),
                          offset = difference(vertex, edge.from, axis);
                part += along * offset;
                length += along * along;
                apart |= along * difference(vertex, edge.from, next) - offset * difference(edge.to, edge.from, next);
            }
            if (apart == 0 && part > 0 && part < length && is_used(vertex)) found.emplace_back(part, vertex);
        }
        std::sort(found.begin(), found.end());
        std::vector<VertexIndex> vertices;
        for (const auto& [part, vertex] : found) vertices.push_back(vertex);
        return vertices;
    }
};

TEST(TJunctions, AreThoseThatAllVerticesHave) {
    std::mt19937 random(9);
    constexpr std::array<Place, 5> kSizes{Place{4, 4, 4}, {60, 2, 2}, {9, 9, 0}, {0, 64, 0}, {30, 30, 30}};
    std::size_t found = 0;
    for (int round = 0; round < 200; ++round) {
        const Place& size = kSizes[random() % kSizes.size()];
        const auto room = static_cast<std::size_t>((size[0] + 1) * (size[1] + 1) * (size[2] + 1));
        const int origin = static_cast<int>(random() % 3) * 200'000 - 200'000;
        const Scatter scatter(random, std::min<std::size_t>(room, 1 + random() % 90), 1 + random() % 60, size, origin);
        const std::vector<TJunction> junctions = find_t_junctions(scatter.level);
        for (const EdgeIndex edge : scatter.level.edges.indices()) {
            std::vector<VertexIndex> on_edge;
            for (const TJunction& each : junctions_on(junctions, edge)) on_edge.push_back(each.vertex);
            const std::vector<VertexIndex> expected = scatter.inside(scatter.level.edges[edge]);
            ASSERT_EQ(on_edge, expected) << round;
            found += expected.size();
        }
    }
    EXPECT_GT(found, 5000u);
}

TEST(TJunctions, OfALevelWithoutVerticesAreNone) {
    EXPECT_TRUE(find_t_junctions(Level{}).empty());
}

/// As far apart as vertices can be: 2^20 units along each axis.
TEST(TJunctions, ReachFromCornerToCornerOfTheWorld) {
    constexpr std::int32_t kEnd = std::numeric_limits<std::int32_t>::max(), kMiddle = 1000 * 4096;
    Level level;
    for (const std::int32_t part : {-kEnd, kEnd, kMiddle - 400 * 4096, kMiddle, kMiddle + 300 * 4096})
        level.vertices.push_back({World::from_raw(part), World::from_raw(part), World::from_raw(part)});
    level.edges = {
        {VertexIndex(0), VertexIndex(1)}, {VertexIndex(2), VertexIndex(4)}, {VertexIndex(3), VertexIndex(3)}};
    for (const EdgeIndex edge : level.edges.indices()) level.surf_edges.push_back({edge, false});
    EXPECT_EQ(find_t_junctions(level), (std::vector<TJunction>{{EdgeIndex(1), VertexIndex(3)}}))
        << "the first is too long: it stays as it is";
}

}  // namespace
}  // namespace oblong::test

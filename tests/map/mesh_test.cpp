#include <gtest/gtest.h>

#include <cmath>

#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

using map::cross;
using map::dot;
using map::length;

// How many vertices lie within `slack` of an edge between its ends, and away from both.
int vertices_on_edges(const map::BspFile& bsp, double slack) {
    std::vector<std::vector<Point>> polygons;
    std::vector<Point> vertices;
    for (const auto& face : bsp.faces) polygons.push_back(corners_of(bsp, face));
    for (const auto& polygon : polygons) vertices.insert(vertices.end(), polygon.begin(), polygon.end());
    int found = 0;
    for (const auto& polygon : polygons) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point from = polygon[i], edge = polygon[(i + 1) % polygon.size()] - from;
            for (const Point& vertex : vertices) {
                const double along = dot(vertex - from, edge) / dot(edge, edge);
                if (along * length(edge) <= slack || (1 - along) * length(edge) <= slack) continue;
                if (length(cross(vertex - from, edge)) <= slack * length(edge)) ++found;
            }
        }
    }
    return found;
}

// All corners are whole numbers here, so the doubles are exact and 0 slack is a proof.
TEST(Mesh, NoVertexLiesInsideAnEdge) {
    const auto bsp = compile(level(room({0, 0, 0}, {512, 512, 256}) + box({0, 64, 0}, {32, 128, 96}) +
                                   box({0, 200, 32}, {64, 256, 160}, "other") + box({96, 0, 0}, {128, 512, 16}) +
                                   box({300, 300, 0}, {333, 341, 256}, "floor")));
    for (const auto& vertex : bsp.vertices) {
        for (const float number : vertex) EXPECT_EQ(number, std::floor(number));
    }
    EXPECT_EQ(vertices_on_edges(bsp, 0), 0);
    EXPECT_EQ(open_edges(bsp), 0);
}

TEST(Mesh, NoVertexLiesNearAnEdgeOfSlantedWalls) {
    const auto bsp = compile(level(room({-256, -256, 0}, {256, 256, 256}) + prism({0, 0, 0}, 80, 200, 11) +
                                   ball({100, 90, 60}, 70, 5, 7, "other")),
                             {true});
    EXPECT_EQ(vertices_on_edges(bsp, 1.0 / 128), 0);
}

}  // namespace
}  // namespace oblong::test

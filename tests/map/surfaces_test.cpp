#include <gtest/gtest.h>

#include <cmath>

#include "engine/level/level.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test::surfaces_test {

namespace {

struct Shape {
    const char* name;
    std::string brushes;
};

std::string hall() {
    return room({-256, -256, 0}, {256, 256, 256});
}

// Five wedges of a half ring whose corners are rounded: their sides do not quite meet in lines.
std::string arch() {
    const std::array<Whole, 6> inner{
        {{-64, 0, 64}, {-56, 0, 96}, {-32, 0, 119}, {32, 0, 119}, {56, 0, 96}, {64, 0, 64}}};
    const std::array<Whole, 6> outer{
        {{-96, 0, 64}, {-83, 0, 112}, {-48, 0, 147}, {48, 0, 147}, {83, 0, 112}, {96, 0, 64}}};
    const auto behind = [](Whole point) { return Whole{point[0], 32, point[2]}; };
    std::string text;
    for (std::size_t i = 0; i + 1 < inner.size(); ++i) {
        const Whole &a = inner[i], &b = inner[i + 1], &c = outer[i], &d = outer[i + 1];
        text += brush({{{a, b, behind(a)}},
                       {{c, behind(c), d}},
                       {{a, behind(a), c}},
                       {{b, d, behind(b)}},
                       {{a, c, b}},
                       {{behind(a), behind(b), behind(c)}}});
    }
    return text;
}

std::vector<Shape> shapes() {
    std::string stairs, pillars, debris;
    for (int i = 0; i < 8; ++i) stairs += box({-256 + 24 * i, -64, 0}, {-232 + 24 * i, 64, 8 * i + 8}, "floor");
    for (int i = 0; i < 5; ++i) pillars += prism({-192 + 96 * i, 150, 0}, 36, 256, 5 + 4 * i);
    for (int i = 0; i < 12; ++i) debris += ball({-180 + 33 * i, -170 + 29 * i, 40 + 13 * i}, 40, 4, 7, "other");
    return {{"box", ""},
            {"pillar", box({-32, -32, 0}, {32, 32, 256})},
            {"stairs", stairs},
            {"pillars of 5 to 21 sides", pillars},
            {"ball of 96 planes", ball({0, 0, 128}, 100, 8, 12)},
            {"overlapping balls", debris},
            {"arch", arch()},
            {"water and lava", box({-256, -256, 0}, {0, 256, 64}, "*water") +
                                   box({0, -256, 0}, {256, 256, 48}, "*lava") + prism({0, 0, 16}, 60, 100, 7)},
            {"sky", box({-128, -128, 240}, {128, 128, 272}, "sky") + ball({40, 40, 200}, 70, 5, 6)}};
}

TEST(Surfaces, AreClosedAndNoLineOfSightMeetsAHole) {
    for (const Shape& shape : shapes()) {
        const auto bsp =
            compile(level(hall() + shape.brushes, entity_at("info_player_start", {-240, -240, 200})), {true});
        EXPECT_EQ(open_edges(bsp), 0) << shape.name;
        EXPECT_EQ(first_fault_of_rays(bsp, 3000, 1), "") << shape.name;
    }
}

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

}  // namespace oblong::test::surfaces_test

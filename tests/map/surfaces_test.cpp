#include "tools/map/tree/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/level/bsp_read.h"
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

// How many samples a reader of the file counts along each axis of a face's lightmap; it keeps texels in floats.
std::array<int, 2> sides_of(const map::BspFile& bsp, const map::FileFace& face) {
    std::array<int, 2> sides{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& axis = bsp.texinfos.at(static_cast<std::size_t>(face.texinfo)).axes[i];
        float low = 1e9F, high = -1e9F;
        for (const Point& p : corners_of(bsp, face)) {
            const auto [x, y, z] = axis.direction;
            const double sum = double{x} * p.x + double{y} * p.y + double{z} * p.z + double{axis.offset};
            low = std::min(low, static_cast<float>(sum));
            high = std::max(high, static_cast<float>(sum));
        }
        sides[i] = static_cast<int>(std::ceil(high / 16) - std::floor(low / 16)) + 1;
    }
    return sides;
}

int samples_of(const map::BspFile& bsp, const map::FileFace& face) {
    const auto [width, height] = sides_of(bsp, face);
    return width * height;
}

// 312 units at 1.3 units a texel are a hair less than 240 texels, 552 at 2.3 and those across 408 at 2.38 a hair more:
// the most of a face.
TEST(Surfaces, NoRoundingErrorAtAWholeStepCutsAFace) {
    const auto faces_of_room = [](int low, int high, const std::string& tail) {
        const std::string plain = room({low, low, 0}, {high, high, 64});
        return compile(level(replaced(plain, " 0 0 0 1 1", tail)), {true}).faces.size();
    };
    EXPECT_EQ(faces_of_room(312, 624, " 0 0 0 1.3 1.3"), 6u);
    EXPECT_EQ(faces_of_room(0, 552, " 0 0 0 2.3 2.3"), 6u);
    EXPECT_EQ(faces_of_room(0, 408, " [ 0.8 0.6 0 0 ] [ 0.6 -0.8 0 0 ] 0 2.38 9"), 6u);
}

// Axes that an editor turned: as doubles, corners at 16 and 256 texels lie a hair beyond the border of a sample.
TEST(Samples, PartsOfAxesThatNoFloatSeesAddNoSamples) {
    const std::string tail = "wall [ 1 6.123e-17 0 0 ] [ 6.123e-17 -1 6.123e-17 0 ] 0 1 1";
    const std::string turned = replaced(room({16, 16, 0}, {256, 256, 96}), "wall 0 0 0 1 1", tail);
    const auto bsp = compile(level(turned, entity_at("light", {136, 136, 64}, {{"light", "900"}})), {true});
    std::size_t sample_count = 0;
    int full_faces = 0;
    for (const auto& face : bsp.faces) {
        ASSERT_EQ(face.light_offset, static_cast<int>(sample_count)) << "lightmaps follow each other";
        sample_count += static_cast<std::size_t>(samples_of(bsp, face));
        full_faces += samples_of(bsp, face) == 16 * 16 ? 1 : 0;
    }
    EXPECT_EQ(sample_count, bsp.lighting.size());
    EXPECT_EQ(full_faces, 2) << "floor and ceiling of 240 by 240 texels";
}

// 16 is what engines have room for; a face of fewer than 16 beside one that goes on has been cut too soon.
TEST(Samples, LargeSurfacesAreCutIntoFacesOfSixteenSamplesAndNoMore) {
    for (const char* tail :
         {"0 0 0 1 1", "5 -7 0 1 1", "3 0 0 0.5 0.75", "0 0 30 1 1", "0 9 45 2 1", "0 0 0 0.3 1.1"}) {
        const std::string large =
            replaced(room({0, 0, 0}, {1200, 1000, 700}), "wall 0 0 0 1 1", std::string("wall ") + tail);
        const auto bsp = compile(level(large), {true});
        int widest = 0, highest = 0;
        for (const auto& face : bsp.faces) {
            const auto [width, height] = sides_of(bsp, face);
            widest = std::max(widest, width);
            highest = std::max(highest, height);
        }
        EXPECT_EQ(widest, 16) << tail;
        EXPECT_EQ(highest, 16) << tail;
    }
}

// 267 x 267 pieces of 240 texels.
TEST(Samples, MoreFacesThanVersion29HoldsAreCutForBsp2) {
    map::TexInfo texinfo;
    texinfo.axes = {Point{64, 0, 0}, Point{0, 64, 0}};
    const map::Surface square{0, {}, 0, {{0, 0, 0}, {0, 1000, 0}, {1000, 1000, 0}, {1000, 0, 0}}};
    EXPECT_EQ(map::subdivided({square}, {texinfo}).size(), 71289u);
    texinfo.axes = {Point{250, 0, 0}, Point{0, 250, 0}};
    EXPECT_THROW(map::subdivided({square}, {texinfo}), InputError) << "1042 x 1042 pieces";
}

}  // namespace
}  // namespace oblong::test::surfaces_test

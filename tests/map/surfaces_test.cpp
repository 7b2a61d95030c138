#include <gtest/gtest.h>

#include "engine/level/level.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test {
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

TEST(Surfaces, EveryEdgeHasItsOpposite) {
    for (const Shape& shape : shapes()) {
        const auto bsp =
            compile(level(hall() + shape.brushes, entity_at("info_player_start", {-240, -240, 200})), {true});
        EXPECT_EQ(open_edges(bsp), 0) << shape.name;
    }
}

TEST(Surfaces, NoLineOfSightMeetsAHole) {
    for (const Shape& shape : shapes()) {
        const auto bsp =
            compile(level(hall() + shape.brushes, entity_at("info_player_start", {-240, -240, 200})), {true});
        EXPECT_EQ(first_fault_of_rays(bsp, 3000, 1), "") << shape.name;
    }
}

}  // namespace
}  // namespace oblong::test

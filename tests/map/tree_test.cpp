#include <gtest/gtest.h>

#include <optional>

#include "engine/level/level.h"
#include "tests/map/brush_world.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test {

namespace {

const Whole kLow{-256, -256, 0}, kHigh{256, 256, 256};

Point random_inside(std::mt19937& random, double margin) {
    return {random_between(random, -256 + margin, 256 - margin), random_between(random, -256 + margin, 256 - margin),
            random_between(random, margin, 256 - margin)};
}

TurnedBox random_box(std::mt19937& random, double least, double most) {
    const auto extent = [&] { return random_between(random, least, most); };
    return {random_inside(random, 20), {extent(), extent(), extent()}, random_frame(random)};
}

// Beyond the room's walls everything is solid.
bool is_in_room(const Point& point) {
    return std::abs(point.x) < 256 && std::abs(point.y) < 256 && std::abs(point.z - 128) < 128;
}

Point random_near(std::mt19937& random, const TurnedBox& box) {
    Point point = box.centre;
    for (std::size_t axis = 0; axis < 3; ++axis)
        point = point + box.frame[axis] * (random_between(random, -1.5, 1.5) * box.half[axis]);
    return point;
}

double face_area(const map::BspFile& bsp, const map::FileFace& face) {
    const auto corners = corners_of(bsp, face);
    Point sum;
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum = sum + cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return length(sum) / 2;
}

double surface_area(const map::BspFile& bsp) {
    double sum = 0;
    for (const auto& face : bsp.faces) sum += face_area(bsp, face);
    return sum;
}

// Of the space that the faces look into, by the divergence theorem: a third of each face's area times the distance of
// its plane.
double enclosed_volume(const map::BspFile& bsp) {
    double sum = 0;
    for (const auto& face : bsp.faces) sum -= face_area(bsp, face) * facing_plane(bsp, face).distance / 3;
    return sum;
}

// Boxes at any angle through each other and through the walls.
std::vector<TurnedBox> random_boxes(std::mt19937& random, int count, double least, double most) {
    std::vector<TurnedBox> boxes;
    for (int i = 0; i < count; ++i) boxes.push_back(random_box(random, least, most));
    return boxes;
}

// They are divided among the kinds of entities whose brushes are the world's.
std::string heap_of(const std::vector<TurnedBox>& boxes) {
    std::string world = room(kLow, kHigh), group, detail;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        (i % 3 == 0 ? world : i % 3 == 1 ? group : detail) += boxes[i].text(i % 2 == 0 ? kStandardTail : kValveTail);
    return level(world, entity("func_group", {{"_tb_type", "_tb_layer"}, {"_tb_name", "a layer"}}, group) +
                            entity("func_detail", {}, detail));
}

TEST(Tree, SolidIsWhatIsInsideABrush) {
    std::mt19937 random(11);
    for (const auto& [count, least, most] : {std::tuple{5, 8, 90}, {20, 8, 60}, {40, 1, 30}, {30, 0.25, 4}}) {
        const auto boxes = random_boxes(random, count, least, most);
        const std::string source = heap_of(boxes);
        const BrushWorld brushes(source);
        const auto bsp = compile(source, {true});
        int solid = 0;
        for (int i = 0; i < 20000; ++i) {
            const TurnedBox& near = boxes[random() % boxes.size()];
            const Point point = i % 2 == 0 ? random_inside(random, 0) : random_near(random, near);
            const bool is_solid = brushes.is_solid(point) || !is_in_room(point);
            if (brushes.is_solid(point, 1.0 / 64) != brushes.is_solid(point, -1.0 / 64)) continue;
            ASSERT_EQ(contents_at(bsp, 0, 0, point) == contents::kSolid, is_solid)
                << count << " boxes, at " << map::point_text(point);
            solid += is_solid ? 1 : 0;
        }
        EXPECT_GT(solid, 1000) << count;
    }
}

TEST(Tree, HeapsAreSealed) {
    std::mt19937 random(12);
    for (const auto& [count, least, most] : {std::tuple{5, 8, 90}, {12, 4, 60}, {24, 1, 16}}) {
        const auto bsp = compile(heap_of(random_boxes(random, count, least, most)), {true});
        EXPECT_EQ(first_fault_of_rays(bsp, 2000, 3), "") << count;
    }
}

// Boxes that do not touch leave the room's volume less their own, and add their surfaces to its.
TEST(Tree, VolumeAndAreaAreTheClosedForms) {
    std::mt19937 random(13);
    double volume = 512.0 * 512 * 256, area = 2 * 512.0 * 512 + 4 * 512 * 256;
    std::string brushes = room(kLow, kHigh);
    for (int i = 0; i < 27; ++i) {
        TurnedBox box = random_box(random, 2, 20);
        box.centre = {-160.0 + 160 * (i % 3), -160.0 + 160 * (i / 3 % 3), 48.0 + 80 * (i / 9)};
        brushes += box.text();
        volume -= box.volume();
        area += 8 * (box.half[0] * box.half[1] + box.half[1] * box.half[2] + box.half[2] * box.half[0]);
    }
    const auto bsp = compile(level(brushes), {true});
    EXPECT_NEAR(enclosed_volume(bsp), volume, surface_area(bsp) / 1024) << "corners are rounded to 1/4096";
    EXPECT_NEAR(surface_area(bsp), area, 10);
}

// Cells of 32 units, filled or not: what is drawn is where a filled one meets an empty one, to the last bit.
TEST(Tree, CellsHaveTheAreaOfTheirOpenSides) {
    constexpr int kCells = 6, kSize = 32;
    std::mt19937 random(14);
    std::array<std::array<std::array<bool, kCells>, kCells>, kCells> filled{};
    std::string brushes = room({0, 0, 0}, {kCells * kSize, kCells * kSize, kCells * kSize});
    for (int cell = 0; cell < kCells * kCells * kCells; ++cell) {
        if (random() % 3 != 0) continue;
        const int x = cell % kCells, y = cell / kCells % kCells, z = cell / kCells / kCells;
        filled.at(static_cast<std::size_t>(x)).at(static_cast<std::size_t>(y)).at(static_cast<std::size_t>(z)) = true;
        brushes += box({x * kSize, y * kSize, z * kSize}, {x * kSize + kSize, y * kSize + kSize, z * kSize + kSize});
    }
    const auto is_filled = [&](int x, int y, int z) {
        if (std::min({x, y, z}) < 0 || std::max({x, y, z}) >= kCells) return true;
        return filled[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)][static_cast<std::size_t>(z)];
    };
    int open_sides = 0;
    for (int x = -1; x < kCells; ++x) {
        for (int y = -1; y < kCells; ++y) {
            for (int z = -1; z < kCells; ++z) {
                const bool here = is_filled(x, y, z);
                open_sides += (here != is_filled(x + 1, y, z)) + (here != is_filled(x, y + 1, z)) +
                              (here != is_filled(x, y, z + 1));
            }
        }
    }
    const auto bsp = compile(level(brushes), {true});
    EXPECT_EQ(surface_area(bsp), open_sides * kSize * kSize);
    EXPECT_EQ(open_edges(bsp), 0);
}

TEST(Tree, ARoomTurnedToAnyAngleIsSealed) {
    std::mt19937 random(15);
    for (int i = 0; i < 12; ++i) {
        const TurnedBox inside{{10.3, -7.7, 31.1}, {128, 100, 64}, random_frame(random)};
        const auto bsp = compile(level(turned_room(inside), entity_at("light", {10, -8, 31})), {true});
        EXPECT_EQ(first_fault_of_rays(bsp, 1000, 4), "") << i;
        EXPECT_NEAR(enclosed_volume(bsp), inside.volume(), surface_area(bsp) / 1024) << i;
    }
}

// A room whose north wall leaves a gap from x = 128 on.
std::string room_with_gap(double gap) {
    const std::string begins_at_minus_1 = box({-1, 256, 0}, {272, 272, 128});
    const std::string east = replaced(begins_at_minus_1, "( -1 ", "( " + std::to_string(128 + gap) + " ");
    return boxes(
               "-16 -16 -16 272 272 0    -16 -16 128 272 272 144    -16 0 0 0 256 128    256 0 0 272 256 128 "
               "-16 -16 0 272 0 128    -16 256 0 128 272 128") +
           east;
}

// A room, and one without the wall at y = 256.
const std::string kClosed = plain_room(), kOpen = kClosed.substr(0, kClosed.rfind("{"));

// How a source leaks; nothing if it does not.
std::optional<map::LeakError> leak_of(const std::string& source) {
    try {
        compile(source, {true});
    } catch (const map::LeakError& leak) {
        return leak;
    }
    return std::nullopt;
}

TEST(Leak, NamesTheEntityAndTheWayOut) {
    const std::string light = entity_at("light", {400, 0, 0});
    const auto says = [](const std::string& source, const std::string& part) {
        const auto leak = leak_of(source);
        ASSERT_TRUE(leak) << "the light outside should leak";
        EXPECT_NE(std::string(leak->what()).find(part), std::string::npos) << leak->what();
    };
    says(level(kClosed, entity_at("info_player_start", {128, 128, 32}) + light),
         "light at 400 0 0 is outside of the level");
    says(level(kClosed, light), "the level leaks: light at 400 0 0");  // no start says which side is inside
}

TEST(Leak, ThePathLeadsThroughTheHole) {
    const std::string start = entity_at("info_player_start", {128, 128, 32});
    const auto leak = leak_of(level(kOpen, start));
    ASSERT_TRUE(leak) << "a room of five walls should leak";
    ASSERT_GE(leak->path.size(), 2u);
    EXPECT_EQ(leak->path.front(), (Point{128, 128, 32}));
    EXPECT_GT(leak->path.back().y, 256);
    EXPECT_EQ(map::point_text({1, 2.5, -3}), "1 2.5 -3");
    EXPECT_FALSE(leak_of(level(kClosed, start)));
}

TEST(Leak, ThePathGoesThroughNoWall) {
    const std::array<std::array<Whole, 2>, 2> baffles{
        {{{{0, 180, 0}, {200, 200, 128}}}, {{{56, 220, 0}, {256, 240, 128}}}}};
    const auto is_solid = [&](const Point& p) {
        if (p.y < 256 && (p.x < 0 || p.x > 256 || p.y < 0 || p.z < 0 || p.z > 128)) return true;
        return std::any_of(baffles.begin(), baffles.end(), [&](const auto& baffle) {
            const auto& [mins, maxs] = baffle;
            return p.x > mins[0] && p.x < maxs[0] && p.y > mins[1] && p.y < maxs[1];
        });
    };
    std::string brushes = kOpen;
    for (const auto& [mins, maxs] : baffles) brushes += box(mins, maxs);
    const auto leak = leak_of(level(brushes, entity_at("info_player_start", {128, 128, 32})));
    ASSERT_TRUE(leak);
    for (std::size_t i = 1; i < leak->path.size(); ++i)
        for (int part = 0; part <= 100; ++part) {
            const Point& from = leak->path[i - 1];
            const Point p = from + (leak->path[i] - from) * (part / 100.0);
            ASSERT_FALSE(is_solid(p)) << p.x << ' ' << p.y << ' ' << p.z;
        }
}

// The room's walls reach from -16 to 272, 272 and 144.
TEST(Leak, OnTheOuterSurfaceOfAWallIsInside) {
    const auto leaks = [](const Whole& origin) {
        return leak_of(level(plain_room(), lights_of_plain_room() + entity_at("path_corner", origin))).has_value();
    };
    const std::vector<Whole> on_surfaces{{-16, 99, 9},  {272, 99, 9},   {99, -16, 9},    {99, 272, 9}, {99, 99, -16},
                                         {99, 99, 144}, {-16, -16, 50}, {272, 272, 144}, {0, 99, 9},   {-16, -16, -16}};
    for (const Whole& origin : on_surfaces) EXPECT_FALSE(leaks(origin)) << origin[0] << ' ' << origin[1];
    for (const Whole& origin : {Whole{-17, 99, 9}, {273, 99, 9}, {99, 99, -17}, {99, 99, 145}, {-16, 99, 200}})
        EXPECT_TRUE(leaks(origin)) << origin[0] << ' ' << origin[1];
}

TEST(Leak, OneOnTheFloorFindsAHole) {
    EXPECT_TRUE(leak_of(level(kOpen, entity_at("info_player_start", {128, 128, 0}))));
}

TEST(Leak, GapsLeakUnlessTheyAreRounding) {
    for (const double gap : {8.0, 1.0, 0.25, 0.05}) {
        EXPECT_TRUE(leak_of(level(room_with_gap(gap), lights_of_plain_room()))) << gap;
    }
    for (const double gap : {0.01, 0.001, 0.0001, 0.0}) {
        const auto bsp = compile(level(room_with_gap(gap), lights_of_plain_room()), {true});
        EXPECT_EQ(first_fault_of_rays(bsp, 1000, 5), "") << gap;
    }
}

}  // namespace

}  // namespace oblong::test

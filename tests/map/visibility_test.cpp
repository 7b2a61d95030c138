#include "tools/map/vis/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <sstream>

#include "engine/io/doubles.h"
#include "engine/io/files.h"
#include "engine/level/level.h"
#include "engine/level/side.h"
#include "tests/map/brush_world.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"
#include "tests/support/folders.h"

namespace oblong::test {

namespace {

// Two rooms of 256 units with a corridor in the shape of a U between them: it leaves each through the wall to the
// north (y), so that no line runs from room to room.
std::string two_rooms() {
    return boxes(
        "-16 -16 -16 912 528 0    -16 -16 128 912 528 144    -16 -16 0 0 528 128    896 -16 0 912 528 128 "
        "0 -16 0 896 0 128    0 512 0 896 528 128    256 0 0 640 448 128 "  // between the rooms, south of the corridor
        "0 256 0 96 512 128    160 256 0 256 448 128    640 256 0 736 448 128    800 256 0 896 512 128");  // its ends
}

// Through a door to the east, around a corner, and through a door to the west that lies farther east: no line passes
// both, and even a draft knows that.
TEST(Visibility, LinesOfSightDoNotTurnBack) {
    const std::string walls = boxes(
        "-16 -16 -16 416 288 0    -16 -16 128 416 288 144    -16 -16 0 0 288 128    400 -16 0 416 288 128 "
        "0 -16 0 400 0 128    0 272 0 400 288 128    96 0 0 104 48 128    96 80 0 104 128 128 "
        "0 128 0 340 144 128    250 144 0 258 200 128    250 232 0 258 272 128");
    for (const bool is_fast : {false, true}) {
        const auto bsp = compile(level(walls), {is_fast});
        const auto seen = visible_leaves(bsp, leaf_at(bsp, {40, 64, 64}));
        EXPECT_TRUE(seen[static_cast<std::size_t>(leaf_at(bsp, {200, 64, 64}))]);
        EXPECT_FALSE(seen[static_cast<std::size_t>(leaf_at(bsp, {200, 216, 64}))]) << (is_fast ? "fast" : "full");
    }
}

// 300 zero bytes are more than one byte counts.
TEST(Visibility, LongRunsOfZeroesAreCut) {
    map::BitSet leaves(300 * 8 + 1);
    leaves.add(300 * 8);
    const std::string row = map::packed_row(leaves, 300 * 8 + 1);
    EXPECT_EQ(row, std::string("\0\xff\0\x2d\x01", 5));
    EXPECT_EQ(map::unpacked_row(row, 0, 300 * 8 + 1), leaves);
}

// The bits behind the last leaf of a row are of no leaf.
TEST(Visibility, ARowHasNoMoreLeavesThanTheLevel) {
    EXPECT_EQ(map::unpacked_row("", -1, 13).count(), 13);
    EXPECT_EQ(map::unpacked_row("\xff\xff", 0, 13).count(), 13);
}

TEST(Visibility, WhatALineOfSightMeetsIsInTheSet) {
    EXPECT_EQ(first_fault_of_rays(compile(level(two_rooms())), 5000, 2), "");
    const auto hall = room({-256, -256, 0}, {256, 256, 256}) + prism({-100, 0, 0}, 60, 256, 6) +
                      prism({90, 40, 0}, 50, 256, 5) + box({-256, -256, 0}, {256, 256, 30}, "*water");
    EXPECT_EQ(first_fault_of_rays(compile(level(hall)), 5000, 3), "");
}

TEST(Visibility, FullSetsAreWithinFastOnes) {
    const auto full = compile(level(two_rooms())), fast = compile(level(two_rooms()), {true});
    ASSERT_EQ(full.leaves.size(), fast.leaves.size());
    int full_count = 0, fast_count = 0;
    for (int leaf = 1; leaf <= full.models[0].visible_leaf_count; ++leaf) {
        const auto few = visible_leaves(full, leaf), many = visible_leaves(fast, leaf);
        for (std::size_t i = 0; i < few.size(); ++i) {
            EXPECT_LE(few[i], many[i]);
            full_count += few[i];
            fast_count += many[i];
        }
    }
    EXPECT_LT(full_count, fast_count);
}

// Rows are shared by leaves that only details tell apart, whatever the details hide.
TEST(Visibility, DetailsDoNotSplitTheSets) {
    const std::string hall = room({-256, -256, 0}, {256, 256, 256});
    const auto bsp = compile(level(hall, entity("func_detail", {}, box({-250, -8, 0}, {250, 8, 250}))));
    EXPECT_EQ(bsp.models.size(), 1u);
    EXPECT_EQ(bsp.entities.find("func_detail"), std::string::npos) << "its brushes are the world's";
    EXPECT_EQ(contents_at(bsp, 0, 0, {0, 0, 100}), contents::kSolid);
    const int south = leaf_at(bsp, {0, -128, 100}), north = leaf_at(bsp, {0, 128, 100});
    ASSERT_NE(south, north);
    EXPECT_TRUE(visible_leaves(bsp, south)[static_cast<std::size_t>(north)]);
    EXPECT_EQ(first_fault_of_rays(bsp, 2000, 4), "");
}

// Held against each leaf's set, decoded by the tests.
TEST(Visibility, TheWidestViewIsThatOfTheLeafThatSeesMostFaces) {
    std::string rooms = two_rooms() + room({1200, 0, 0}, {1600, 400, 128});  // the last one is sealed
    for (int x = 1220; x < 1580; x += 30) rooms += box({x, 60, 0}, {x + 10, 70, 60});
    const auto bsp = compile(level(rooms));
    std::size_t most = 0;
    for (int leaf = 1; leaf <= bsp.models[0].visible_leaf_count; ++leaf) {
        const auto seen = visible_leaves(bsp, leaf);
        std::set<int> faces;
        for (std::size_t i = 1; i < bsp.leaves.size(); ++i)
            for (int k = 0; seen[i] && k < bsp.leaves[i].mark_face_count; ++k)
                faces.insert(bsp.mark_faces[static_cast<std::size_t>(bsp.leaves[i].first_mark_face + k)]);
        most = std::max(most, faces.size());
    }
    const map::WidestView widest = map::widest_view(bsp);
    EXPECT_EQ(static_cast<std::size_t>(widest.faces), most);
    EXPECT_LT(most, bsp.faces.size());
    EXPECT_GT(widest.place.x, 1200) << "the pillars are in the sealed room";
}

// As other programs read the file: a polygon runs clockwise seen from the cluster that is named first, which is a leaf
// here. Cluster 0 is leaf 1.
TEST(Visibility, PortalsInTheFileFaceTheirFirstCluster) {
    map::PortalFile portals;
    const auto bsp = compile(level(two_rooms()), {.portals = &portals});
    std::istringstream text(portals.text);
    std::string word;
    std::size_t clusters = 0, count = 0;
    text >> word >> clusters >> count;
    EXPECT_EQ(word, "PRT1");
    EXPECT_EQ(clusters, static_cast<std::size_t>(bsp.models[0].visible_leaf_count));
    EXPECT_EQ(count, portals.count);
    EXPECT_GT(count, 2u);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t corners = 0;
        int first = 0, second = 0;
        text >> corners >> first >> second;
        map::Winding winding(corners);
        char bracket = 0;
        for (Point& corner : winding) text >> bracket >> corner.x >> corner.y >> corner.z >> bracket;
        const Point back = map::area_vector(winding), middle = map::middle(winding);
        EXPECT_EQ(leaf_at(bsp, middle - back * (1 / length(back))), first + 1);
        EXPECT_EQ(leaf_at(bsp, middle + back * (1 / length(back))), second + 1);
    }
    EXPECT_TRUE(text);
}

// Lines of sight nearer to a brush than this are not judged.
constexpr double kMargin = 1.0 / 32;

// Pairs of points that see each other, found from the brushes alone; what of the level's sets denies it is counted.
struct Witness {
    int seen = 0, denied = 0;
};

class Sight {
  public:
    Sight(const std::string& map_text, const std::string& bsp_bytes)
        : brushes_(map_text), level_(engine_level(bsp_bytes)), visible_(visible_set_size(level_)) {}

    // Half of the pairs lie anywhere, half near each other's height: those see farther.
    Witness test(int pairs, unsigned seed) {
        std::mt19937 random(seed);
        Witness witness;
        for (int i = 0; i < pairs; ++i) {
            const Point from = random_point(random);
            Point to = random_point(random);
            if (i % 2 == 0) to.z = from.z + (to.z - from.z) / 16;
            const LeafIndex here = open_leaf(from), there = open_leaf(to);
            if (here == kSolidOutside || there == kSolidOutside || brushes_.is_blocked(from, to, kMargin)) continue;
            ++witness.seen;
            if (!sees(here, there) || !sees(there, here)) ++witness.denied;
        }
        return witness;
    }

  private:
    Point random_point(std::mt19937& random) const {
        const map::Box& box = brushes_.box();
        return {random_between(random, box.mins.x, box.maxs.x), random_between(random, box.mins.y, box.maxs.y),
                random_between(random, box.mins.z, box.maxs.z)};
    }

    // The leaf at a point, 0 in brushes and outside of the level.
    LeafIndex open_leaf(const Point& point) const {
        const LeafIndex leaf = find_leaf(level_, level_.world(), to_world(point));
        const std::int32_t filling = level_.leaves[leaf].contents;
        return filling == contents::kSolid || filling == contents::kSky ? kSolidOutside : leaf;
    }

    bool sees(LeafIndex from, LeafIndex to) {
        unpack_visible_set(level_, from, visible_);
        return is_in_set(visible_, to);
    }

    BrushWorld brushes_;
    Level level_;
    std::vector<std::uint8_t> visible_;
};

TEST(Sight, LinesThatMeetNoBrushAreInTheSets) {
    std::mt19937 random(5);
    const auto at = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low));
    };
    for (int i = 0; i < 8; ++i) {
        std::string brushes = room({-512, -512, 0}, {512, 512, 256});
        for (int k = 0; k < 4 + i; ++k) {
            const Whole low{at(-512, 400), at(-512, 400), at(0, 2) * 96};
            brushes += box(low, {low[0] + at(16, 400), low[1] + at(16, 400), low[2] + at(16, 160)});
            brushes += prism({at(-450, 450), at(-450, 450), 0}, at(24, 90), at(40, 256), at(3, 8));
        }
        const std::string text = level(brushes);
        const Witness witness = Sight(text, map::to_bytes(compile(text))).test(4000, static_cast<unsigned>(i));
        EXPECT_GT(witness.seen, 100) << i;
        EXPECT_EQ(witness.denied, 0) << "of " << witness.seen << " in scene " << i;
    }
}

TEST(Sight, LinesOfTheDemoLevelAreInTheSets) {
    Sight sight(read_text(test::source_folder() + "/assets/demo.map"),
                read_text(test::build_folder() + "/assets/demo.bsp"));
    const Witness witness = sight.test(400000, 9);
    EXPECT_GT(witness.seen, 5000);
    EXPECT_EQ(witness.denied, 0) << "of " << witness.seen;
}

}  // namespace

}  // namespace oblong::test

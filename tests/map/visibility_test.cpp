#include <gtest/gtest.h>

#include "engine/level/level.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

// Two rooms of 256 units with a corridor in the shape of a U between them: it leaves each through the wall to the
// north (y), so that no line runs from room to room.
std::string two_rooms() {
    std::string walls;
    const auto solid = [&](Whole mins, Whole maxs) { walls += box(mins, maxs); };
    solid({-16, -16, -16}, {912, 528, 0});    // floor
    solid({-16, -16, 128}, {912, 528, 144});  // ceiling
    solid({-16, -16, 0}, {0, 528, 128});
    solid({896, -16, 0}, {912, 528, 128});
    solid({0, -16, 0}, {896, 0, 128});
    solid({0, 512, 0}, {896, 528, 128});
    solid({256, 0, 0}, {640, 448, 128});  // between the rooms, south of the corridor
    solid({0, 256, 0}, {96, 512, 128});   // around the corridor's western end
    solid({160, 256, 0}, {256, 448, 128});
    solid({640, 256, 0}, {736, 448, 128});
    solid({800, 256, 0}, {896, 512, 128});
    return walls;
}

TEST(Visibility, RoomsAroundCornersDoNotSeeEachOther) {
    for (const bool is_fast : {false, true}) {
        const auto bsp = compile(level(two_rooms()), {is_fast});
        const int west = leaf_at(bsp, {40, 40, 64}), east = leaf_at(bsp, {860, 40, 64});
        EXPECT_TRUE(visible_leaves(bsp, west)[static_cast<std::size_t>(west)]);
        EXPECT_FALSE(visible_leaves(bsp, west)[static_cast<std::size_t>(east)]) << (is_fast ? "fast" : "full");
        EXPECT_FALSE(visible_leaves(bsp, east)[static_cast<std::size_t>(west)]) << (is_fast ? "fast" : "full");
    }
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

}  // namespace
}  // namespace oblong::test

#include "game/simulation/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace oblong {
namespace {

// Boxes of many sizes, some inside out, as damaged files have them.
Box random_box(std::mt19937& random, int largest) {
    const auto draw = [&](int low, int high) { return static_cast<std::int32_t>(random() % (high - low + 1)) + low; };
    const auto x = draw(-4000, 4000), y = draw(-4000, 4000), z = draw(-500, 500);
    return {world_vector(x, y, z),
            world_vector(x + draw(-20, largest), y + draw(-20, largest), z + draw(-20, largest))};
}

TEST(BoxTree, FindsWhatLookingAtEachBoxFinds) {
    std::mt19937 random(7);
    for (const std::size_t count : {0u, 1u, 4u, 5u, 9u, 300u}) {
        std::vector<BoxTree::Entry> entries;
        for (std::size_t i = 0; i < count; ++i)
            entries.push_back({random_box(random, i % 10 == 0 ? 5000 : 200), static_cast<std::uint32_t>(1000 - i)});
        const BoxTree tree(entries);
        for (int query = 0; query < 200; ++query) {
            const Box area = random_box(random, 600);
            std::vector<std::uint32_t> expected;
            for (const BoxTree::Entry& entry : entries)
                if (entry.box.overlaps(area)) expected.insert(expected.begin(), entry.number);
            ASSERT_EQ(tree.overlapping(area), expected) << count << " boxes, query " << query;
        }
    }
}

TEST(BoxTree, EqualBoxesAreAllFound) {
    const Box box{world_vector(0, 0, 0), world_vector(1, 1, 1)};
    std::vector<BoxTree::Entry> entries;
    for (std::uint32_t i = 0; i < 1000; ++i) entries.push_back({box, i});
    EXPECT_EQ(BoxTree(entries).overlapping(box).size(), 1000u);
}

/// Asks for the parts of what a tree finds in an area, each after the other.
template <class Check>
std::vector<std::uint32_t> parts_of(const BoxTree& tree, const Box& area, Check check) {
    std::vector<std::uint32_t> all;
    std::uint32_t from = 0;
    int parts = 0;
    do {
        const BoxTree::Part part = tree.part_overlapping(area, from);
        EXPECT_LE(part.looks, BoxTree::kMostLooks);
        EXPECT_TRUE(check(part, from));
        all.insert(all.end(), part.numbers.begin(), part.numbers.end());
        from = part.next;
        ++parts;
    } while (from != 0 && !testing::Test::HasFailure());
    EXPECT_GT(parts, 3);
    return all;
}

// Pairs of boxes that cross away from an area which the box around both holds.
TEST(BoxTreeParts, EndAfterAsManyLooks) {
    std::vector<BoxTree::Entry> entries;
    for (std::uint32_t i = 0; i < 20'000; ++i)
        entries.push_back({{{}, i % 2 == 0 ? world_vector(1000, 1, 9) : world_vector(1, 1000, 9)}, i});
    parts_of(BoxTree(entries), {world_vector(500, 500, 1), world_vector(510, 510, 5)},
             [](const BoxTree::Part& part, std::uint32_t from) {
                 return part.numbers.empty() && (part.next == 0 || part.next > from);
             });
}

TEST(BoxTreeParts, TogetherAreTheWhole) {
    std::vector<BoxTree::Entry> entries;
    for (std::uint32_t i = 0; i < 5000; ++i) {
        const auto x = static_cast<std::int32_t>(i * 7919 % 4000), y = static_cast<std::int32_t>(i * 104'729 % 4000);
        entries.push_back({{world_vector(x, y, 0), world_vector(x + 900, y + 900, 9)}, i});
    }
    const BoxTree tree(entries);
    const Box area{world_vector(1500, 1500, 0), world_vector(2500, 2500, 5)};
    std::vector<std::uint32_t> all = parts_of(tree, area, [](const BoxTree::Part& part, std::uint32_t) {
        return part.numbers.size() <= std::size_t{BoxTree::kMostFound};
    });
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, tree.overlapping(area));
}

}  // namespace
}  // namespace oblong

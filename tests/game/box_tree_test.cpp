#include "game/simulation/box_tree.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace oblong

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "engine/methods/pixel_owners.h"
#include "tests/methods/scanned_scene.h"

namespace oblong::test {
namespace {

PixelOwners painted(const ScannedScene& scene, std::span<const std::int32_t> order) {
    PixelOwners owners = no_owners();
    find_owners_by_painting(scene.scanned, order, owners);
    return owners;
}

std::vector<std::int32_t> sorted_by(SortDepth depth, const ScannedScene& scene) {
    std::int64_t comparisons = 0;
    return back_to_front_by_depth(scene.scanned, depth, comparisons);
}

/// Three faces, none of which reaches through another: 0 is before 2 on the left, 2 before 1 on the right, and 1 before
/// 0 in the middle.
ScannedScene cycle() {
    ScannedScene scene;
    scene.add_shape(0, 2, std::array<PixelRange, 2>{{{0, 10}, {0, 10}}}, 40, 72);
    scene.add_shape(1, 2, std::array<PixelRange, 4>{{{8, 16}, {8, 16}, {12, 16}, {12, 16}}}, 40, 66);
    scene.add_shape(2, 2, std::array<PixelRange, 4>{{{0, 4}, {0, 4}, {0, 4}, {0, 16}}}, 50, 51);
    return scene;
}

TEST(Painter, LaterFacesCoverEarlierOnes) {
    ScannedScene scene;
    scene.add(0, {0, 10, 0, 1}, 50, 50);
    scene.add(1, {5, kWidth, 0, 1}, 100, 100);
    EXPECT_EQ(text_of_row(painted(scene, std::vector{1, 0}), 0), "0000000000111111");
    EXPECT_EQ(text_of_row(painted(scene, std::vector{0, 1}), 0), "0000011111111111");
    EXPECT_EQ(painted(scene, std::vector{0, 1}).counts.pixels_written, 21);
}

TEST(Painter, ByTheTreeIsTheReverseOfTheWalk) {
    ScannedScene scene;
    for (int face = 0; face < 4; ++face) scene.add(face, {0, 1, 0, 1}, 10, 10);
    EXPECT_EQ(back_to_front_by_tree(scene.scanned), (std::vector{3, 2, 1, 0}));
}

TEST(Painter, SortsByTheFarthestOrTheMeanDepth) {
    ScannedScene scene;
    scene.add(0, {0, 1, 0, 1}, 60, 60);
    scene.add(1, {0, 1, 0, 1}, 10, 100);
    EXPECT_EQ(sorted_by(SortDepth::Farthest, scene), (std::vector{1, 0}));
    EXPECT_EQ(sorted_by(SortDepth::Mean, scene), (std::vector{0, 1}));
}

TEST(Painter, EquallyDeepFacesStayAsTheTreeHasThem) {
    ScannedScene scene;
    for (int face = 0; face < 3; ++face) scene.add(face, {0, 1, 0, 1}, 10, 10);
    EXPECT_EQ(sorted_by(SortDepth::Farthest, scene), (std::vector{2, 1, 0}));
}

TEST(Painter, LargeFaceThatReachesFartherIsPaintedFirstThoughItIsNearer) {
    ScannedScene scene;  // a floor from 10 to 200, and a lid under it all the way that ends at 100
    scene.add(0, {0, kWidth, 0, 1}, 10, 200);
    scene.add(1, {0, 6, 0, 1}, 90, 100);
    const PixelOwners wrong = painted(scene, sorted_by(SortDepth::Farthest, scene));
    EXPECT_EQ(text_of_row(wrong, 0), "1111110000000000");
    PixelOwners right = no_owners();
    std::vector<InverseZ> depths;
    find_owners_by_z_buffer(scene.scanned, depths, right);
    EXPECT_EQ(text_of_row(right, 0), "0000000000000000");
}

TEST(Painter, NoOrderOfFacesThatOverlapInACycleIsRight) {
    const ScannedScene scene = cycle();
    PixelOwners right = no_owners();
    std::vector<InverseZ> depths;
    find_owners_by_z_buffer(scene.scanned, depths, right);
    EXPECT_EQ(text_of_row(right, 2), "0000000011111111");
    EXPECT_EQ(text_of_row(right, 4), "2222........1111");
    EXPECT_EQ(text_of_row(right, 5), "2222222222222222");
    std::vector<std::int32_t> order(scene.size());
    std::iota(order.begin(), order.end(), 0);
    do {
        EXPECT_NE(painted(scene, order).faces, right.faces) << order[0] << order[1] << order[2];
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Painter, FacesSeenThroughAreSeenUnlessALaterFaceCoversThem) {
    ScannedScene scene;
    scene.add(0, {0, 4, 0, 1}, 20, 20);
    scene.add(1, {0, 8, 0, 1}, 50, 50, true);
    scene.add(2, {0, 6, 0, 1}, 90, 90);
    const PixelOwners owners = painted(scene, back_to_front_by_tree(scene.scanned));
    EXPECT_EQ(text_of_row(owners, 0), "000022..........");
    ASSERT_EQ(owners.seen.size(), 1u);
    EXPECT_EQ(owners.seen[0].span.first, 4);
    EXPECT_EQ(owners.seen[0].span.end, 8);
}

}  // namespace
}  // namespace oblong::test

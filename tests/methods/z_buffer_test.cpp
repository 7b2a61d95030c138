#include <gtest/gtest.h>

#include "engine/methods/pixel_owners.h"
#include "tests/methods/scanned_scene.h"

namespace oblong::test {
namespace {

PixelOwners owners_of(const ScannedScene& scene) {
    PixelOwners owners = no_owners();
    std::vector<InverseZ> depths;
    find_owners_by_z_buffer(scene.scanned, depths, owners);
    return owners;
}

TEST(ZBuffer, FacesThatCrossArePartedWhereTheyAreEquallyDeep) {
    ScannedScene scene;
    scene.add(0, {0, kWidth, 0, kHeight}, 50, 100);
    scene.add(1, {0, kWidth, 0, kHeight}, 100, 50);
    // 1/z is linear in the column, and the two are mirror images: they cross in the middle.
    EXPECT_EQ(text_of_row(owners_of(scene), 0), "0000000011111111");
}

TEST(ZBuffer, FirstOfTheFileKeepsAPixelThatTwoFacesAreEquallyDeepAt) {
    ScannedScene scene;
    scene.add(7, {0, 10, 0, 1}, 80, 80);
    scene.add(3, {5, kWidth, 0, 1}, 80, 80);
    EXPECT_EQ(text_of_row(owners_of(scene), 0), "0000011111111111");
}

TEST(ZBuffer, DepthsStayWithinTheFacesOwn) {
    ScannedScene scene;
    scene.add(0, {0, kWidth, 0, kHeight}, 40, 60);
    const FaceDepth depth(scene.scanned.faces[0]);
    EXPECT_EQ(depth.at(-1000, 0), inverse_of(40));
    EXPECT_EQ(depth.at(1000, 0), inverse_of(60));
    EXPECT_NEAR(static_cast<double>(depth.at(0, 0).raw), static_cast<double>(inverse_of(40).raw), 64);
}

TEST(ZBuffer, FacesSeenThroughAreSeenBeforeTheOwnerAndHideNothing) {
    ScannedScene scene;
    scene.add(0, {0, 8, 0, kHeight}, 50, 50);
    scene.add(1, {0, kWidth, 2, 3}, 75, 75, true);
    scene.add(2, {0, kWidth, 0, kHeight}, 100, 100);
    const PixelOwners owners = owners_of(scene);
    EXPECT_EQ(text_of_row(owners, 2), "0000000022222222");
    ASSERT_EQ(owners.seen.size(), 1u);
    EXPECT_EQ(owners.seen[0].face, 1);
    EXPECT_EQ(std::tuple(owners.seen[0].span.y, owners.seen[0].span.first, owners.seen[0].span.end),
              std::tuple(2, 8, kWidth));
}

TEST(ZBuffer, CountsPixelsTestedAndWritten) {
    ScannedScene scene;
    scene.add(0, {0, kWidth, 0, 1}, 50, 50);
    scene.add(1, {0, kWidth, 0, 1}, 100, 100);
    scene.add(2, {0, 4, 0, 1}, 25, 25);
    const PixelOwners owners = owners_of(scene);
    EXPECT_EQ(owners.counts.pixels_tested, 2 * kWidth + 4);
    EXPECT_EQ(owners.counts.pixels_written, kWidth + 4);
}

TEST(OwnedRuns, AreByFaceThenByRow) {
    ScannedScene scene;
    scene.add(0, {4, 6, 0, 2}, 50, 50);
    scene.add(1, {0, kWidth, 0, 2}, 100, 100);
    const std::vector<OwnedRun> runs = owned_runs(owners_of(scene));
    std::string text;
    for (const auto& [face, span] : runs)
        text += std::to_string(face) + ":" + std::to_string(span.y) + "[" + std::to_string(span.first) + "," +
                std::to_string(span.end) + ") ";
    EXPECT_EQ(text, "0:0[4,6) 0:1[4,6) 1:0[0,4) 1:0[6,16) 1:1[0,4) 1:1[6,16) ");
}

}  // namespace
}  // namespace oblong::test

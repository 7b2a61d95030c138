#include "engine/methods/pixel_owners.h"

#include <gtest/gtest.h>

#include <numeric>

#include "engine/io/doubles.h"

namespace oblong::test {
namespace {

constexpr std::int32_t kWidth = 16, kHeight = 8;

InverseZ inverse_of(double z) {
    return fixed_of<InverseZ>(1 / z);
}

/// Faces that cover parts of a small screen.
struct ScannedScene {
    ScannedFaces scanned;

    /// Columns of each row from `first_row` on; z at the screen's first and last column.
    void add_shape(int face, std::int32_t first_row, std::span<const PixelRange> columns, double first_z, double last_z,
                   bool is_seen_through = false) {
        ScannedFace made;
        made.face = FaceIndex(face);
        made.nearest_z = fixed_of<View>(std::min(first_z, last_z));
        made.farthest_z = fixed_of<View>(std::max(first_z, last_z));
        made.is_seen_through = is_seen_through;
        made.inverse_z.origin = inverse_of(first_z);
        made.inverse_z.per_column = InverseZ::from_raw((inverse_of(last_z) - inverse_of(first_z)).raw / (kWidth - 1));
        ScanlineExtents rows(kHeight);
        rows.first = first_row;
        rows.end = first_row + static_cast<std::int32_t>(columns.size());
        for (std::int32_t y = rows.first; y < rows.end; ++y) {
            item(rows.left, y) = item(columns, y - first_row).first;
            item(rows.right, y) = item(columns, y - first_row).end;
        }
        add_face(made, rows, kWidth, {}, {}, scanned);
    }
    void add(int face, const ScreenRectangle& pixels, double first_z, double last_z, bool is_seen_through = false) {
        const std::vector<PixelRange> columns(static_cast<std::size_t>(pixels.end_row - pixels.first_row),
                                              {pixels.first_column, pixels.end_column});
        add_shape(face, pixels.first_row, columns, first_z, last_z, is_seen_through);
    }
    std::size_t size() const { return scanned.faces.size(); }
};

PixelOwners no_owners() {
    PixelOwners owners;
    owners.start(kWidth, kHeight);
    return owners;
}

/// A row as text: the number of each pixel's owner, '.' where there is none.
std::string text_of_row(const PixelOwners& owners, std::int32_t y) {
    std::string text;
    for (std::int32_t x = 0; x < owners.width_px; ++x)
        text += owners.row(y)[x] < 0 ? '.' : static_cast<char>('0' + owners.row(y)[x]);
    return text;
}

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
    EXPECT_EQ(owners.counts.pixels_tested, 8 * kHeight + kWidth + kWidth * kHeight);
    ASSERT_EQ(owners.seen.size(), 1u);
    EXPECT_EQ(owners.seen[0].face, 1);
    EXPECT_EQ(std::tuple(owners.seen[0].span.y, owners.seen[0].span.first, owners.seen[0].span.end),
              std::tuple(2, 8, kWidth));
}

TEST(ZBuffer, CountsPixelsTestedAndWritten) {
    ScannedScene scene;
    scene.add(0, {0, kWidth, 0, 1}, 50, 50);
    scene.add(1, {0, kWidth, 0, 1}, 100, 100);
    scene.add(2, {1, 5, 0, 1}, 25, 25);
    PixelOwners owners = owners_of(scene);
    EXPECT_EQ(owners.counts.pixels_tested, 2 * kWidth + 4);
    EXPECT_EQ(owners.counts.pixels_written, kWidth + 4);
    owners.start(kWidth, kHeight);
    EXPECT_EQ(owners.counts.pixels_tested, 0);
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

TEST(Painter, NoOrderOfFacesThatOverlapInACycleIsRight) {
    const ScannedScene scene = cycle();
    const PixelOwners right = owners_of(scene);
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

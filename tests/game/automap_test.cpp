// The map of a wall that stands on a floor, with places worked out by hand.

#include "game/view/automap.h"

#include <gtest/gtest.h>

#include "tests/game/logic_level.h"

namespace oblong::test {
namespace {

/// The floor z = 0 and, east of x = 64, a block of some height; one face, of the block's side toward the west.
Level level_with_wall(std::int32_t block_height, std::int32_t face_bottom = 0, std::int32_t face_top = 200) {
    Level level;
    const PlaneIndex floor = add_plane(level, 2, 0), side = add_plane(level, 0, 64),
                     top = add_plane(level, 2, block_height);
    const NodeChild solid{LeafIndex(0)}, open{LeafIndex(1)};
    level.leaves.resize(2);
    level.leaves[LeafIndex(0)].contents = contents::kSolid;
    level.leaves[LeafIndex(1)].mark_faces = {Index<MarkFace>(0), 1};
    level.mark_faces.push_back(FaceIndex(0));
    level.nodes.push_back({floor, {NodeChild(NodeIndex(1)), solid}, {}, {}});
    level.nodes.push_back({side, {NodeChild(NodeIndex(2)), open}, {}, {FaceIndex(0), 1}});
    level.nodes.push_back({top, {open, solid}, {}, {}});

    for (const auto& [y, z] : {std::pair{0, face_bottom}, {0, face_top}, {64, face_top}, {64, face_bottom}}) {
        level.vertices.push_back(world_vector(64, y, z));
        const std::int32_t corner = level.vertices.count() - 1;
        level.edges.push_back({VertexIndex(corner), VertexIndex((corner + 1) % 4)});
        level.surf_edges.push_back({EdgeIndex(corner), false});
    }
    level.texinfos.resize(1);
    Face face;
    face.plane = side;
    face.is_back = true;
    face.edges = {Index<SurfEdge>(0), 4};
    level.faces.push_back(face);
    SubModel world;
    world.root = NodeChild(NodeIndex(0));
    world.faces = {FaceIndex(0), 1};
    world.visible_leaf_count = 1;
    level.models.push_back(world);
    return level;
}

TEST(MapLines, AreWhereAWallMeetsTheFloor) {
    const std::vector<MapLine> lines = map_lines_of(level_with_wall(128), FaceIndex(0));
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0], (MapLine{world_vector(64, 64, 0), world_vector(64, 0, 0), MapLineKind::Wall}));
}

TEST(MapLines, OfWhatThePlayerCanWalkUpAreSteps) {
    const auto kind_at = [](std::int32_t height) {
        return map_lines_of(level_with_wall(height), FaceIndex(0)).at(0).kind;
    };
    EXPECT_EQ(kind_at(16), MapLineKind::Step);
    EXPECT_EQ(kind_at(18), MapLineKind::Step);
    EXPECT_EQ(kind_at(24), MapLineKind::Wall);
}

TEST(MapLines, LeaveOutWallsAboveTheGroundFloorsLiquidsAndSkies) {
    EXPECT_TRUE(map_lines_of(level_with_wall(128, 96), FaceIndex(0)).empty()) << "as over a door";
    for (const Material material : {Material::Liquid, Material::Sky}) {
        Level level = level_with_wall(128);
        level.texinfos[TexInfoIndex(0)].material = material;
        EXPECT_TRUE(map_lines_of(level, FaceIndex(0)).empty());
    }
    Level level = level_with_wall(128);
    level.faces[FaceIndex(0)].plane = PlaneIndex(0);
    EXPECT_TRUE(map_lines_of(level, FaceIndex(0)).empty()) << "a floor";
}

class MapOfAWall : public testing::Test {
  protected:
    MapOfAWall() {
        for (std::size_t i = 0; i < 256; ++i) data_.palette.colours[i].red = static_cast<std::uint8_t>(i);
        data_.level = level_with_wall(128);
        level_.bsp = &data_.level;
        map_ = std::make_unique<Automap>(data_, level_, ColourScheme::Standard);
    }

    // Whether a pixel is on a line; the eye is at (0, 32), 64 units before the middle of the wall.
    void draw(MapView orientation, Angle yaw, const ScreenMode& mode = {}) {
        mode_ = mode;
        pixels_.assign(pixel_count(mode.width_px, mode.height_px), 0);
        const GameState state;
        GameView view{{state, state}, {}};
        view.camera.eye = world_vector(0, 32, 40);
        view.camera.yaw = yaw;
        map_->draw(view, orientation, LineMethod::Bresenham, mode, {},
                   {pixels_.data(), mode.width_px, mode.height_px, mode.width_px});
    }
    bool is_line(std::int32_t x, std::int32_t y) const { return pixels_.at(as_size(y * mode_.width_px + x)) != 0; }

    GameData data_;
    GameLevel level_;
    std::unique_ptr<Automap> map_;
    ScreenMode mode_;
    std::vector<std::uint8_t> pixels_;
};

// 320 pixels show 2,048 units: a wall 64 units east is 10 columns right, and reaches 32 units up and down: 5 pixels as
// wide as they are high, or 4.17 that are 6/5 as high.
TEST_F(MapOfAWall, ShowsItInTheEastWithNorthUp) {
    draw(MapView::NorthUp, kHalfTurn);
    for (std::int32_t y = 96; y <= 103; ++y) {
        EXPECT_TRUE(is_line(170, y)) << y;
        EXPECT_FALSE(is_line(169, y) || is_line(171, y)) << y;
    }
    EXPECT_FALSE(is_line(170, 94) || is_line(170, 105));
}

TEST_F(MapOfAWall, HasTheAspectOfTheMode) {
    draw(MapView::NorthUp, kHalfTurn, {320, 240, {4, 3}});
    for (std::int32_t y = 115; y <= 124; ++y) EXPECT_TRUE(is_line(170, y)) << y;
    EXPECT_FALSE(is_line(170, 113) || is_line(170, 126));
}

// Ahead, 64 units are 8.33 of the higher pixels.
TEST_F(MapOfAWall, TurnsWithThePlayer) {
    draw(MapView::PlayerUp, Angle{});
    for (const std::int32_t x : {156, 157, 158, 162, 163, 164}) {
        EXPECT_TRUE(is_line(x, 91)) << x;
        EXPECT_FALSE(is_line(x, 90)) << x;
    }
    EXPECT_FALSE(is_line(153, 91) || is_line(167, 91));
}

}  // namespace
}  // namespace oblong::test

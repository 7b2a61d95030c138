#include <gtest/gtest.h>

#include "tests/frame/frame_fixture.h"

namespace oblong::test {
namespace {

Camera camera_at(std::int32_t x, std::int32_t y, std::int32_t z, std::int64_t yaw_degrees) {
    Camera camera;
    camera.eye = {World::from_int(x), World::from_int(y), World::from_int(z)};
    camera.yaw = Angle::from_bam(yaw_degrees * 65536 / 360);
    return camera;
}

/// The colour of the nearest written pixel on the row, the left one of two; 0 where the row has none.
std::uint8_t nearest_on_row(const std::vector<std::uint8_t>& pixels, const std::vector<std::uint8_t>& writes,
                            std::int32_t column, std::int32_t row) {
    const auto at = [&](std::int32_t x) { return static_cast<std::size_t>(row * 320 + x); };
    for (std::int32_t away = 1; away < 320; ++away) {
        if (column - away >= 0 && writes[at(column - away)]) return pixels[at(column - away)];
        if (column + away < 320 && writes[at(column + away)]) return pixels[at(column + away)];
    }
    return 0;
}

/// The demo level with every fifth vertex moved up by some units, and the faces of every eleventh node left out.
TEST(TornLevel, AFreePixelTakesTheColourOfItsNearestNeighbour) {
    Stage stage = demo_stage();
    for (auto vertex = stage.level.vertices.begin(); stage.level.vertices.end() - vertex > 5; vertex += 5)
        vertex->z += World::from_int(6);
    for (auto node = stage.level.nodes.begin(); stage.level.nodes.end() - node > 11; node += 11) node->faces.count = 0;

    FrameWorkspace work(stage.level, stage.mode);
    int free_pixels = 0;
    for (const std::int64_t yaw : {0, 90, 180, 270}) {
        work.counts = std::make_unique<FrameCounts>();
        stage.draw(camera_at(0, 40, 70, yaw), work);
        for (std::int32_t row = 0; row < 200; ++row)
            for (std::int32_t column = 0; column < 320; ++column) {
                const auto at = static_cast<std::size_t>(row * 320 + column);
                if (work.counts->writes[at]) continue;
                ++free_pixels;
                ASSERT_EQ(stage.pixels[at], nearest_on_row(stage.pixels, work.counts->writes, column, row))
                    << column << ", " << row;
            }
    }
    EXPECT_GT(free_pixels, 100);
}

/// One corner of one face moved tears the two edges that meet in it: four are walked by one face alone.
TEST(TornLevel, EveryEdgeThatOneFaceAloneWalksIsCounted) {
    Stage stage = demo_stage();
    ASSERT_EQ(make_face_table(stage.level).torn_edges, 0u);
    const Face& face = stage.level.faces[stage.level.world().faces.first];
    SurfEdge& last = stage.level.surf_edges[face.edges.first];
    const Edge torn = stage.level.edges[last.edge];
    stage.level.vertices.push_back(stage.level.vertices[last.is_reversed ? torn.to : torn.from] +
                                   Vec3<World>{World::from_int(3), World::from_int(1), World::from_int(2)});
    const VertexIndex moved(static_cast<std::int32_t>(stage.level.vertices.size()) - 1);
    stage.level.edges.push_back(last.is_reversed ? Edge{torn.from, moved} : Edge{moved, torn.to});
    last.edge = EdgeIndex(static_cast<std::int32_t>(stage.level.edges.size()) - 1);
    const std::size_t torn_edges = make_face_table(stage.level).torn_edges;
    // The moved ends of two edges, and those edges' other faces; more where other vertices lie on them.
    EXPECT_GE(torn_edges, 4u);
    EXPECT_LT(torn_edges, 40u);
}

}  // namespace
}  // namespace oblong::test

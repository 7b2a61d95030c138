// Real levels have corners of faces in the middle of other faces' edges (hard case E9). In the outlines that are drawn
// there are none left: looked for here by brute force, in doubles.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "engine/level/t_junctions.h"
#include "engine/scene/face_table.h"
#include "tests/frame/frame_fixture.h"
#include "tests/support/point.h"

namespace oblong::test {

namespace {

Point point_of(const Level& level, VertexIndex vertex) {
    return to_point(level.vertices[vertex]);
}

/// Whether p lies on the edge from a to b, nearer than 1/600 unit to it and farther than 1/100 from its ends.
bool is_inside_edge(const Point& a, const Point& b, const Point& p) {
    const Point along = b - a, offset = p - a;
    const double size = length(along);
    if (size == 0) return false;
    const double part = dot(offset, along) / size;
    if (part < 0.01 || part > size - 0.01) return false;
    return length(offset - along * (part / size)) < 1.0 / 600;
}

bool has_vertex_inside(const Level& level, const std::vector<VertexIndex>& by_x, VertexIndex from, VertexIndex to) {
    const Point a = point_of(level, from), b = point_of(level, to);
    const auto first = std::partition_point(
        by_x.begin(), by_x.end(), [&](VertexIndex v) { return point_of(level, v).x < std::min(a.x, b.x) - 0.01; });
    for (auto v = first; v != by_x.end() && point_of(level, *v).x <= std::max(a.x, b.x) + 0.01; ++v)
        if (is_inside_edge(a, b, point_of(level, *v))) return true;
    return false;
}

std::vector<VertexIndex> used_vertices_by_x(const Level& level, const FaceTable& table) {
    const std::set<VertexIndex> used(table.corners.begin(), table.corners.end());
    std::vector<VertexIndex> sorted(used.begin(), used.end());
    std::sort(sorted.begin(), sorted.end(),
              [&](VertexIndex a, VertexIndex b) { return point_of(level, a).x < point_of(level, b).x; });
    return sorted;
}

class MendedOutlines : public OfLevel {};

}  // namespace

TEST_P(MendedOutlines, HardCaseE9_NoCornerLiesWithinAnEdge) {
    const Stage stage = real_stage(GetParam());
    const FaceTable table = make_face_table(stage.level);
    const std::vector<VertexIndex> by_x = used_vertices_by_x(stage.level, table);
    for (const FaceIndex face : stage.level.faces.indices()) {
        const std::span<const VertexIndex> corners = table.corners_of(face);
        for (std::size_t i = 0; i < corners.size(); ++i)
            ASSERT_FALSE(has_vertex_inside(stage.level, by_x, corners[i], corners[(i + 1) % corners.size()]))
                << face.number();
    }
}

/// So that a frame has no hole: FrontToBackWalk (visibility/front_to_back.h).
TEST_P(MendedOutlines, TheFacesOfTheWorldAreAClosedSurface) {
    const Stage stage = real_stage(GetParam());
    const FaceTable table = make_face_table(stage.level);
    using Place = std::array<std::int32_t, 3>;
    const auto place_of = [&](VertexIndex vertex) {
        const Vec3<World>& p = stage.level.vertices[vertex];
        return Place{p.x.raw, p.y.raw, p.z.raw};
    };
    std::map<std::pair<Place, Place>, int> walked;  // of each edge, how often more in its direction than back
    for (const FaceIndex face : stage.level.world().faces) {
        const std::span<const VertexIndex> corners = table.corners_of(face);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Place from = place_of(corners[i]), to = place_of(corners[(i + 1) % corners.size()]);
            ++walked[{from, to}];
            --walked[{to, from}];
        }
    }
    EXPECT_GT(walked.size(), 5000u);
    EXPECT_EQ(std::count_if(walked.begin(), walked.end(), [](const auto& edge) { return edge.second != 0; }), 0);
}

TEST_P(MendedOutlines, CornersComeInTheOrderOfTheFaceAndSomeAreNew) {
    const Stage stage = real_stage(GetParam());
    const FaceTable table = make_face_table(stage.level);
    std::size_t added = 0;
    for (const FaceIndex index : stage.level.faces.indices()) {
        const std::span<const SurfEdge> edges = stage.level.edges_of(stage.level.faces[index]);
        const std::span<const VertexIndex> corners = table.corners_of(index);
        std::size_t at = 0;  // the file's corners must all be met, in their order
        for (const SurfEdge edge : edges) {
            while (at < corners.size() && corners[at] != stage.level.start_of(edge)) ++at;
            ASSERT_LT(at, corners.size()) << index.number();
        }
        added += corners.size() - edges.size();
    }
    EXPECT_GT(added, 0u) << "these levels are known to have T-junctions";
}

OBLONG_FOR_REAL_LEVELS(MendedOutlines);

}  // namespace oblong::test

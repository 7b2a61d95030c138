#include "engine/geometry/screen_polygon.h"

#include <algorithm>

namespace oblong {

namespace {

/// Clips polygon.clip.polygon to the sides in `outcodes` and projects what is left.
bool clip_and_project(unsigned outcodes, const ViewContext& view, ScreenPolygon& polygon) {
    if (outcodes != 0) clip_polygon(view.frustum, outcodes, polygon.clip);
    if (polygon.clip.polygon.size() < 3) return false;
    polygon.is_clipped = true;
    polygon.nearest_z = View::highest();
    polygon.farthest_z = View{};
    polygon.screen.clear();
    for (const ClipVertex& vertex : polygon.clip.polygon) {
        polygon.nearest_z = std::min(polygon.nearest_z, vertex.position.z);
        polygon.farthest_z = std::max(polygon.farthest_z, vertex.position.z);
        const ScreenVertex inside =
            to_screen_vertex(project(vertex.position, view.projection), view.projection, view.grid);
        polygon.screen.push_back(to_screen_border(inside, vertex.borders, view.projection));
    }
    return true;
}

void use_cached_projections(const ViewContext& view, ScreenPolygon& polygon) {
    polygon.is_clipped = false;
    polygon.nearest_z = View::highest();
    polygon.farthest_z = View{};
    polygon.screen.clear();
    for (CachedVertex* corner : polygon.corners) {
        polygon.nearest_z = std::min(polygon.nearest_z, corner->view.z);
        polygon.farthest_z = std::max(polygon.farthest_z, corner->view.z);
        polygon.screen.push_back(VertexCache::project_once(*corner, view));
    }
}

/// Which sides of the view corners are outside of: any of them, all of them.
struct OutcodeUnion {
    unsigned any = 0, all = 0xff;

    void add(unsigned outcode) {
        any |= outcode;
        all &= outcode;
    }
};

template <bool AdjustsPositions>
OutcodeUnion gather_corners(std::span<const VertexIndex> corner_indices, const ViewContext& view, VertexCache& vertices,
                            std::vector<CachedVertex*>& corners) {
    OutcodeUnion outcodes;
    corners.clear();
    for (const VertexIndex index : corner_indices) {
        CachedVertex& vertex = vertices.get<AdjustsPositions>(index, view);
        outcodes.add(vertex.outcode);
        corners.push_back(&vertex);
    }
    return outcodes;
}

}  // namespace

bool project_face(std::span<const VertexIndex> corner_indices, const ViewContext& view, VertexCache& vertices,
                  ScreenPolygon& polygon) {
    const OutcodeUnion outcodes = view.adjusts_positions
                                      ? gather_corners<true>(corner_indices, view, vertices, polygon.corners)
                                      : gather_corners<false>(corner_indices, view, vertices, polygon.corners);
    if (outcodes.all != 0) return false;
    if (outcodes.any == 0) {
        use_cached_projections(view, polygon);
        return true;
    }
    polygon.clip.polygon.clear();
    for (const CachedVertex* corner : polygon.corners)
        polygon.clip.polygon.push_back({corner->view, 0, corner->outcode, 0});
    return clip_and_project(outcodes.any, view, polygon);
}

bool project_polygon(std::span<const Vec3<World>> corners, const ViewContext& view, ScreenPolygon& polygon) {
    OutcodeUnion outcodes;
    polygon.clip.polygon.clear();
    for (const Vec3<World>& corner : corners) {
        const Vec3<View> vertex = to_view(corner, view);
        const std::uint8_t outcode = outcode_of(view.frustum, vertex);
        outcodes.add(outcode);
        polygon.clip.polygon.push_back({vertex, 0, outcode, 0});
    }
    return outcodes.all == 0 && clip_and_project(outcodes.any, view, polygon);
}

}  // namespace oblong

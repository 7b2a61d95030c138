#include "engine/geometry/screen_polygon.h"

#include <algorithm>

namespace oblong {

namespace {

/// Clips polygon.clip.polygon to the sides in `outcodes` and projects what is left.
bool clip_and_project(unsigned outcodes, const ViewContext& view, ScreenPolygon& polygon) {
    if (outcodes != 0) clip_polygon(view.frustum, outcodes, polygon.clip);
    if (polygon.clip.polygon.size() < 3) return false;
    polygon.nearest_z = View::highest();
    polygon.screen.clear();
    for (const ClipVertex& vertex : polygon.clip.polygon) {
        polygon.nearest_z = std::min(polygon.nearest_z, vertex.position.z);
        const ScreenVertex inside =
            to_screen_vertex(project(vertex.position, view.projection), view.projection, view.grid);
        polygon.screen.push_back(to_screen_border(inside, vertex.borders, view.projection));
    }
    return true;
}

void use_cached_projections(const ViewContext& view, ScreenPolygon& polygon) {
    polygon.nearest_z = View::highest();
    polygon.screen.clear();
    for (CachedVertex* corner : polygon.corners) {
        polygon.nearest_z = std::min(polygon.nearest_z, corner->view.z);
        polygon.screen.push_back(VertexCache::project_once(*corner, view));
    }
}

}  // namespace

bool project_face(std::span<const VertexIndex> corner_indices, const ViewContext& view, VertexCache& vertices,
                  ScreenPolygon& polygon) {
    unsigned any_outside = 0, all_outside = 0xff;
    polygon.corners.clear();
    for (const VertexIndex index : corner_indices) {
        CachedVertex& vertex = vertices.get(index, view);
        any_outside |= vertex.outcode;
        all_outside &= vertex.outcode;
        polygon.corners.push_back(&vertex);
    }
    if (all_outside != 0) return false;
    if (any_outside == 0) {
        use_cached_projections(view, polygon);
        return true;
    }
    polygon.clip.polygon.clear();
    for (const CachedVertex* corner : polygon.corners)
        polygon.clip.polygon.push_back({corner->view, 0, corner->outcode, 0});
    return clip_and_project(any_outside, view, polygon);
}

bool project_polygon(std::span<const Vec3<World>> corners, const ViewContext& view, ScreenPolygon& polygon) {
    unsigned any_outside = 0, all_outside = 0xff;
    polygon.clip.polygon.clear();
    for (const Vec3<World>& corner : corners) {
        const Vec3<View> vertex = to_view(corner, view.eye, view.axes);
        const std::uint8_t outcode = outcode_of(view.frustum, vertex);
        any_outside |= outcode;
        all_outside &= outcode;
        polygon.clip.polygon.push_back({vertex, 0, outcode, 0});
    }
    return all_outside == 0 && clip_and_project(any_outside, view, polygon);
}

}  // namespace oblong

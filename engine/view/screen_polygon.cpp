#include "engine/view/screen_polygon.h"

#include <algorithm>

namespace oblong {

namespace {

/// A corner's screen vertex, computed on first use. The corner is inside the view.
ScreenVertex project_once(ClipVertex& corner, const ViewContext& view) {
    if (!corner.is_projected) {
        const ScreenVertex inside = to_screen_vertex(corner.position, view.projection, view.grid);
        corner.screen = to_screen_border(inside, corner.borders, view.projection);
        corner.is_projected = true;
    }
    return corner.screen;
}

/// The sides that some corners are outside of, and those that all are.
struct Outcodes {
    unsigned of_any = 0, of_all = 0xff;

    void add(unsigned outcode) {
        of_any |= outcode;
        of_all &= outcode;
    }
};

/// Clips and projects the polygon in polygon.clipper. False if it is outside the view.
bool clip_and_project(const Outcodes& outcodes, const ViewContext& view, ScreenPolygon& polygon) {
    if (outcodes.of_all != 0) return false;
    if (outcodes.of_any != 0) polygon.clipper.clip(view.frustum, outcodes.of_any);
    const std::span<ClipVertex* const> corners = polygon.clipper.corners();
    if (corners.size() < 3) return false;
    const std::span<ScreenVertex> screen = polygon.projected.take(corners.size());
    ScreenVertex* out = screen.data();
    for (ClipVertex* const corner : corners) *out++ = project_once(*corner, view);
    polygon.vertices = screen;
    return true;
}

/// Where a face's corners go.
struct Corners {
    ClipVertex** vertices;
    ScreenVertex* screen;  ///< arbitrary for corners outside the view
};

template <bool AdjustsPositions>
Outcodes gather_corners(std::span<const VertexIndex> corner_indices, const ViewContext& view, VertexCache& vertices,
                        Corners out) {
    Outcodes outcodes;
    for (const VertexIndex index : corner_indices) {
        ClipVertex& vertex = vertices.get<AdjustsPositions>(index, view);
        outcodes.add(vertex.outcode);
        *out.vertices++ = &vertex;
        *out.screen++ = vertex.screen;
    }
    return outcodes;
}

}  // namespace

std::pair<View, View> ScreenPolygon::z_range() const {
    View nearest = View::highest(), farthest;
    for (const ClipVertex* const corner : clipper.corners()) {
        nearest = std::min(nearest, corner->position.z);
        farthest = std::max(farthest, corner->position.z);
    }
    return {nearest, farthest};
}

bool project_face(std::span<const VertexIndex> corner_indices, const ViewContext& view, VertexCache& vertices,
                  ScreenPolygon& polygon) {
    const std::size_t count = corner_indices.size();
    const std::span<ScreenVertex> screen = polygon.projected.take(count);
    const Corners corners{polygon.clipper.start(count).data(), screen.data()};
    const Outcodes outcodes = view.adjusts_positions ? gather_corners<true>(corner_indices, view, vertices, corners)
                                                     : gather_corners<false>(corner_indices, view, vertices, corners);
    polygon.is_clipped = outcodes.of_any != 0;
    if (polygon.is_clipped) return clip_and_project(outcodes, view, polygon);
    polygon.vertices = screen;
    return count >= 3;
}

bool project_polygon(std::span<const Vec3<World>> corners, const ViewContext& view, ScreenPolygon& polygon) {
    Outcodes outcodes;
    ClipVertex* own = polygon.own.take(corners.size()).data();
    ClipVertex** out = polygon.clipper.start(corners.size()).data();
    for (const Vec3<World>& corner : corners) {
        own->is_projected = place_vertex(corner, view, *own);
        own->undecided = 0;
        outcodes.add(own->outcode);
        *out++ = own++;
    }
    polygon.is_clipped = true;
    return clip_and_project(outcodes, view, polygon);
}

}  // namespace oblong

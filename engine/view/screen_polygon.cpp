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

/// The union and the intersection of corners' outcodes.
struct OutcodeUnion {
    unsigned any = 0, all = 0xff;

    void add(unsigned outcode) {
        any |= outcode;
        all &= outcode;
    }
};

/// Clips and projects the polygon in polygon.clipper. False if it is outside the view.
bool clip_and_project(const OutcodeUnion& outcodes, const ViewContext& view, ScreenPolygon& polygon) {
    if (outcodes.all != 0) return false;
    if (outcodes.any != 0) polygon.clipper.clip(view.frustum, outcodes.any);
    const std::span<ClipVertex* const> corners = polygon.clipper.corners();
    if (corners.size() < 3) return false;
    const std::span<ScreenVertex> screen = polygon.projected.take(corners.size());
    ScreenVertex* out = screen.data();
    View nearest = View::highest(), farthest;
    for (ClipVertex* const corner : corners) {
        nearest = std::min(nearest, corner->position.z);
        farthest = std::max(farthest, corner->position.z);
        *out++ = project_once(*corner, view);
    }
    polygon.screen = screen;
    polygon.nearest_z = nearest;
    polygon.farthest_z = farthest;
    return true;
}

template <bool AdjustsPositions>
OutcodeUnion gather_corners(std::span<const VertexIndex> corner_indices, const ViewContext& view, VertexCache& vertices,
                            std::span<ClipVertex*> corners) {
    OutcodeUnion outcodes;
    ClipVertex** out = corners.data();
    for (const VertexIndex index : corner_indices) {
        ClipVertex& vertex = vertices.get<AdjustsPositions>(index, view);
        outcodes.add(vertex.outcode);
        *out++ = &vertex;
    }
    return outcodes;
}

}  // namespace

bool project_face(std::span<const VertexIndex> corner_indices, const ViewContext& view, VertexCache& vertices,
                  ScreenPolygon& polygon) {
    const std::span<ClipVertex*> corners = polygon.clipper.start(corner_indices.size());
    const OutcodeUnion outcodes = view.adjusts_positions
                                      ? gather_corners<true>(corner_indices, view, vertices, corners)
                                      : gather_corners<false>(corner_indices, view, vertices, corners);
    polygon.is_clipped = outcodes.any != 0;
    return clip_and_project(outcodes, view, polygon);
}

bool project_polygon(std::span<const Vec3<World>> corners, const ViewContext& view, ScreenPolygon& polygon) {
    OutcodeUnion outcodes;
    ClipVertex* own = polygon.own.take(corners.size()).data();
    ClipVertex** out = polygon.clipper.start(corners.size()).data();
    for (const Vec3<World>& corner : corners) {
        see(corner, view, *own);
        own->undecided = 0;
        own->is_projected = false;
        outcodes.add(own->outcode);
        *out++ = own++;
    }
    polygon.is_clipped = true;
    return clip_and_project(outcodes, view, polygon);
}

}  // namespace oblong

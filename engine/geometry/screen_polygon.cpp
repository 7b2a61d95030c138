#include "engine/geometry/screen_polygon.h"

#include <algorithm>

namespace oblong {

namespace {

ScreenVertex seen_at(const ClipVertex& corner, const ViewContext& view) {
    const ScreenVertex inside = to_screen_vertex(project(corner.position, view.projection), view.projection, view.grid);
    return to_screen_border(inside, corner.borders, view.projection);
}

/// Fills polygon.screen and the polygon's depths: `depth_of` and `place_of` tell those of a corner.
template <class Corner, class Depth, class Place>
void fill_screen(std::span<Corner> corners, Depth depth_of, Place place_of, ScreenPolygon& polygon) {
    View nearest = View::highest(), farthest;
    const std::span<ScreenVertex> screen = polygon.projected.take(corners.size());
    ScreenVertex* out = screen.data();
    for (Corner& corner : corners) {
        const View z = depth_of(corner);
        nearest = std::min(nearest, z);
        farthest = std::max(farthest, z);
        *out++ = place_of(corner);
    }
    polygon.screen = screen;
    polygon.nearest_z = nearest;
    polygon.farthest_z = farthest;
}

/// Clips polygon.clip.polygon to the sides in `outcodes` and projects what is left.
bool clip_and_project(unsigned outcodes, const ViewContext& view, ScreenPolygon& polygon) {
    if (outcodes != 0) clip_polygon(view.frustum, outcodes, polygon.clip);
    if (polygon.clip.polygon.size() < 3) return false;
    polygon.is_clipped = true;
    fill_screen(
        std::span(polygon.clip.polygon), [](const ClipVertex& corner) { return corner.position.z; },
        [&view](const ClipVertex& corner) { return seen_at(corner, view); }, polygon);
    return true;
}

void use_cached_projections(std::span<CachedVertex*> corners, const ViewContext& view, ScreenPolygon& polygon) {
    polygon.is_clipped = false;
    fill_screen(
        corners, [](const CachedVertex* corner) { return corner->view.z; },
        [&view](CachedVertex* corner) { return VertexCache::project_once(*corner, view); }, polygon);
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
                            std::span<CachedVertex*> corners) {
    OutcodeUnion outcodes;
    CachedVertex** out = corners.data();
    for (const VertexIndex index : corner_indices) {
        CachedVertex& vertex = vertices.get<AdjustsPositions>(index, view);
        outcodes.add(vertex.outcode);
        *out++ = &vertex;
    }
    return outcodes;
}

}  // namespace

bool project_face(std::span<const VertexIndex> corner_indices, const ViewContext& view, VertexCache& vertices,
                  ScreenPolygon& polygon) {
    const std::span<CachedVertex*> corners = polygon.cached.take(corner_indices.size());
    const OutcodeUnion outcodes = view.adjusts_positions
                                      ? gather_corners<true>(corner_indices, view, vertices, corners)
                                      : gather_corners<false>(corner_indices, view, vertices, corners);
    if (outcodes.all != 0) return false;
    if (outcodes.any == 0) {
        use_cached_projections(corners, view, polygon);
        return true;
    }
    polygon.clip.polygon.clear();
    for (const CachedVertex* corner : corners) polygon.clip.polygon.push_back({corner->view, 0, corner->outcode, 0});
    return clip_and_project(outcodes.any, view, polygon);
}

bool project_polygon(std::span<const Vec3<World>> corners, const ViewContext& view, ScreenPolygon& polygon) {
    OutcodeUnion outcodes;
    polygon.clip.polygon.clear();
    for (const Vec3<World>& corner : corners) {
        const Vec3<View> position = to_view(corner, view);
        const std::uint8_t outcode = outcode_of(view.frustum, position);
        outcodes.add(outcode);
        polygon.clip.polygon.push_back({position, 0, outcode, 0});
    }
    return outcodes.all == 0 && clip_and_project(outcodes.any, view, polygon);
}

}  // namespace oblong

#include "engine/visible/outline.h"

#include <algorithm>
#include <limits>

namespace oblong {

namespace {

/// Clips outline.clip.polygon to the sides in `outcodes` and projects what is left.
bool clip_and_project(unsigned outcodes, const ViewContext& view, Outline& outline) {
    if (outcodes != 0) clip_polygon(view.frustum, outcodes, outline.clip);
    if (outline.clip.polygon.size() < 3) return false;
    outline.nearest_z_16 = std::numeric_limits<std::int64_t>::max();
    outline.screen.clear();
    for (const ClipVertex& vertex : outline.clip.polygon) {
        outline.nearest_z_16 = std::min(outline.nearest_z_16, vertex.position.z.raw);
        const ScreenVertex inside = to_screen_vertex(project(vertex.position, view.lens), view.lens, view.grid);
        outline.screen.push_back(to_screen_border(inside, vertex.borders, view.lens));
    }
    return true;
}

void use_cached_projections(const ViewContext& view, Outline& outline) {
    outline.nearest_z_16 = std::numeric_limits<std::int64_t>::max();
    outline.screen.clear();
    for (CachedVertex* corner : outline.corners) {
        outline.nearest_z_16 = std::min(outline.nearest_z_16, corner->view.z.raw);
        outline.screen.push_back(VertexCache::project_once(*corner, view));
    }
}

}  // namespace

bool make_face_outline(std::span<const std::int32_t> corner_indices, const ViewContext& view, VertexCache& vertices,
                       Outline& outline) {
    unsigned any_outside = 0, all_outside = 0xff;
    outline.corners.clear();
    for (const std::int32_t index : corner_indices) {
        CachedVertex& vertex = vertices.get(index, view);
        any_outside |= vertex.outcode;
        all_outside &= vertex.outcode;
        outline.corners.push_back(&vertex);
    }
    if (all_outside != 0) return false;
    if (any_outside == 0) {
        use_cached_projections(view, outline);
        return true;
    }
    outline.clip.polygon.clear();
    for (const CachedVertex* corner : outline.corners)
        outline.clip.polygon.push_back({corner->view, 0, corner->outcode, 0});
    return clip_and_project(any_outside, view, outline);
}

bool make_polygon_outline(std::span<const Vec3<World>> corners, const ViewContext& view, Outline& outline) {
    unsigned any_outside = 0, all_outside = 0xff;
    outline.clip.polygon.clear();
    for (const Vec3<World>& corner : corners) {
        const Vec3<View> vertex = to_view(corner, view.eye, view.axes);
        const std::uint8_t outcode = outcode_of(view.frustum, vertex);
        any_outside |= outcode;
        all_outside &= outcode;
        outline.clip.polygon.push_back({vertex, 0, outcode, 0});
    }
    return all_outside == 0 && clip_and_project(any_outside, view, outline);
}

void claim_outline(const Outline& outline, RowColumns& rows, Coverage& coverage, std::vector<Span>& owned) {
    scan_convex(outline.screen, rows);
    for (std::int32_t y = rows.first; y < rows.end; ++y)
        coverage.claim(y, rows.left[static_cast<std::size_t>(y)], rows.right[static_cast<std::size_t>(y)], owned);
}

}  // namespace oblong

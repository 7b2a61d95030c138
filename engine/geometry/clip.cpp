#include "engine/geometry/clip.h"

#include <algorithm>

#include "engine/base/range_probe.h"
#include "engine/fixed/share.h"

namespace oblong {

namespace {

constexpr ClipDistance kOn{};

bool is_outside(const ClipVertex& vertex, const ClipPlane& plane, std::uint8_t border) {
    if (!(vertex.undecided & border)) return (vertex.outcode & border) != 0;
    return plane.distance(vertex.position) < kOn;
}

/// A rounded position may be a step across the plane from its decided side; it then counts as on the plane.
ClipVertex crossing_of(const ClipVertex& inside, const ClipVertex& outside, const ClipPlane& plane,
                       std::uint8_t border) {
    const ClipDistance distance = plane.distance(inside.position);
    const ClipDistance beyond = std::min(plane.distance(outside.position), kOn);
    ClipVertex crossing;
    crossing.position =
        distance <= kOn ? inside.position : cross_plane(inside.position, distance, outside.position, beyond);
    // Both ends on a border: so is every point between.
    crossing.borders = static_cast<std::uint8_t>((inside.borders & outside.borders) | border);
    crossing.outcode = inside.outcode & outside.outcode;
    crossing.undecided =
        static_cast<std::uint8_t>(inside.undecided | outside.undecided | (inside.outcode ^ outside.outcode));
    return crossing;
}

}  // namespace

Vec3<View> cross_plane(const Vec3<View>& inside, ClipDistance distance_inside, const Vec3<View>& outside,
                       ClipDistance distance_outside) {
    const ClipDistance whole = distance_inside - distance_outside;
    note_range<"clip distance, whole edge">(whole);
    const Share share(distance_inside, whole);
    const auto along = [&share](View from, View to) { return from + View::from_raw(share.of((to - from).raw)); };
    return {along(inside.x, outside.x), along(inside.y, outside.y), along(inside.z, outside.z)};
}

void clip_to_plane(const ClipPlane& plane, std::uint8_t border, const std::vector<ClipVertex>& in,
                   std::vector<ClipVertex>& out) {
    out.clear();
    const ClipVertex* previous = &in.back();
    bool was_outside = is_outside(*previous, plane, border);
    for (const ClipVertex& vertex : in) {
        const bool is_out = is_outside(vertex, plane, border);
        if (is_out != was_outside)
            out.push_back(is_out ? crossing_of(*previous, vertex, plane, border)
                                 : crossing_of(vertex, *previous, plane, border));
        if (!is_out) out.push_back(vertex);
        previous = &vertex;
        was_outside = is_out;
    }
}

void clip_polygon(const Frustum& frustum, unsigned outcodes, ClipScratch& scratch) {
    for (unsigned plane = 0; plane < kClipPlaneCount; ++plane) {
        if (!(outcodes >> plane & 1)) continue;
        if (scratch.polygon.size() < 3) break;
        clip_to_plane(frustum.clip_planes[plane], static_cast<std::uint8_t>(1u << plane), scratch.polygon,
                      scratch.other);
        scratch.polygon.swap(scratch.other);
    }
    if (scratch.polygon.size() < 3) scratch.polygon.clear();
}

}  // namespace oblong

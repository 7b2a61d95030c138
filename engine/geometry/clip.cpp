#include "engine/geometry/clip.h"

#include <algorithm>

#include "engine/base/range_probe.h"
#include "engine/fixed/wide.h"

namespace oblong {

namespace {

View interpolate(View from, View to, std::int64_t part, std::int64_t whole) {
    return View::from_raw(from.raw + mul_div(to.raw - from.raw, part, whole, Rounding::NearestHalfUp));
}

bool is_outside(const ClipVertex& vertex, const ClipPlane& plane, std::uint8_t border) {
    if (border != 0 && !(vertex.undecided & border)) return (vertex.outcode & border) != 0;
    return plane.distance(vertex.position) < 0;
}

/// Rounded positions may lie a step on the other side of where they were decided to be; then they lie on the plane.
void append_crossing(const ClipVertex& inside, const ClipVertex& outside, const ClipPlane& plane, std::uint8_t border,
                     std::vector<ClipVertex>& out) {
    const std::int64_t distance = plane.distance(inside.position);
    if (distance <= 0 && border == 0) return;
    const std::int64_t beyond = std::min(plane.distance(outside.position), std::int64_t{0});
    ClipVertex crossing;
    crossing.position =
        distance <= 0 ? inside.position : cross_plane(inside.position, distance, outside.position, beyond);
    // Both ends on a border: so is what lies between.
    crossing.borders = static_cast<std::uint8_t>((inside.borders & outside.borders) | border);
    crossing.outcode = inside.outcode & outside.outcode;
    crossing.undecided =
        static_cast<std::uint8_t>(inside.undecided | outside.undecided | (inside.outcode ^ outside.outcode));
    out.push_back(crossing);
}

}  // namespace

Vec3<View> cross_plane(const Vec3<View>& inside, std::int64_t distance_inside, const Vec3<View>& outside,
                       std::int64_t distance_outside) {
    const std::int64_t whole = distance_inside - distance_outside;
    note_range<Quantity::ClipWhole>(whole);
    return {interpolate(inside.x, outside.x, distance_inside, whole),
            interpolate(inside.y, outside.y, distance_inside, whole),
            interpolate(inside.z, outside.z, distance_inside, whole)};
}

void clip_to_plane(const ClipPlane& plane, std::uint8_t border, const std::vector<ClipVertex>& in,
                   std::vector<ClipVertex>& out) {
    out.clear();
    const ClipVertex* previous = &in.back();
    bool was_outside = is_outside(*previous, plane, border);
    for (const ClipVertex& vertex : in) {
        const bool is_out = is_outside(vertex, plane, border);
        if (is_out && !was_outside) append_crossing(*previous, vertex, plane, border, out);
        if (!is_out && was_outside) append_crossing(vertex, *previous, plane, border, out);
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

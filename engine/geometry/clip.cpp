#include "engine/geometry/clip.h"

#include "engine/base/range_probe.h"
#include "engine/fixed/wide.h"

namespace oblong {

namespace {

View interpolate(View from, View to, std::int64_t part, std::int64_t whole) {
    return View::from_raw(from.raw + mul_div(to.raw - from.raw, part, whole, Rounding::NearestHalfUp));
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
    std::int64_t previous_distance = plane.distance(previous->position);
    for (const ClipVertex& vertex : in) {
        const std::int64_t distance = plane.distance(vertex.position);
        // Both ends on a border: so is what lies between.
        const auto borders = static_cast<std::uint8_t>((previous->borders & vertex.borders) | border);
        if (previous_distance > 0 && distance < 0)
            out.push_back({cross_plane(previous->position, previous_distance, vertex.position, distance), borders});
        if (previous_distance < 0 && distance > 0)
            out.push_back({cross_plane(vertex.position, distance, previous->position, previous_distance), borders});
        if (distance >= 0) out.push_back(vertex);
        previous = &vertex;
        previous_distance = distance;
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

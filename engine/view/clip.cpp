#include "engine/view/clip.h"

#include <algorithm>

#include "engine/base/range_probe.h"
#include "engine/base/table.h"
#include "engine/fixed/share.h"

namespace oblong {

namespace {

constexpr ClipDistance kOn{};

bool is_outside(const ClipVertex& vertex, const ClipPlane& plane, std::uint8_t border) {
    if (!(vertex.undecided & border)) return (vertex.outcode & border) != 0;
    return plane.distance(vertex.position) < kOn;
}

/// Rounding may put a position a step beyond the plane, on the other side than decided; it then counts as on the plane.
ClipVertex crossing_of(const ClipVertex& inside, const ClipVertex& outside, const ClipPlane& plane,
                       std::uint8_t border) {
    const ClipDistance distance = plane.distance(inside.position);
    const ClipDistance beyond = std::min(plane.distance(outside.position), kOn);
    ClipVertex crossing;
    crossing.position =
        distance <= kOn ? inside.position : cross_plane(inside.position, distance, outside.position, beyond);
    // If both ends are on a border, so is every point between.
    crossing.borders = static_cast<std::uint8_t>((inside.borders & outside.borders) | border);
    // On the side of both ends; where they differ, it is undecided.
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

void PolygonClipper::clip_to_plane(const ClipPlane& plane, std::uint8_t border) {
    current_ = 1 - current_;
    const std::span<ClipVertex*> kept = buffers_[current_].take(2 * corners_.size());
    ClipVertex** out = kept.data();
    ClipVertex* previous = corners_.back();
    bool was_outside = is_outside(*previous, plane, border);
    for (ClipVertex* const vertex : corners_) {
        const bool is_out = is_outside(*vertex, plane, border);
        if (is_out != was_outside) {
            made_.push_back(is_out ? crossing_of(*previous, *vertex, plane, border)
                                   : crossing_of(*vertex, *previous, plane, border));
            *out++ = &made_.back();
        }
        if (!is_out) *out++ = vertex;
        previous = vertex;
        was_outside = is_out;
    }
    corners_ = kept.first(as_size(out - kept.data()));
}

void PolygonClipper::clip(const Frustum& frustum, unsigned outcodes) {
    made_.clear();
    for (unsigned plane = 0; plane < kClipPlaneCount && corners_.size() >= 3; ++plane)
        if (outcodes >> plane & 1) clip_to_plane(frustum.clip_planes[plane], static_cast<std::uint8_t>(1u << plane));
    if (corners_.size() < 3) corners_ = {};
}

namespace {

void start_with(std::vector<ClipVertex>& polygon, PolygonClipper& clipper) {
    ClipVertex** out = clipper.start(polygon.size()).data();
    for (ClipVertex& vertex : polygon) *out++ = &vertex;
}

void copy_corners(const PolygonClipper& clipper, std::vector<ClipVertex>& out) {
    out.clear();
    for (const ClipVertex* const vertex : clipper.corners()) out.push_back(*vertex);
}

}  // namespace

void clip_polygon(const Frustum& frustum, unsigned outcodes, ClipScratch& scratch) {
    start_with(scratch.polygon, scratch.clipper);
    scratch.clipper.clip(frustum, outcodes);
    copy_corners(scratch.clipper, scratch.other);
    scratch.polygon.swap(scratch.other);
}

}  // namespace oblong

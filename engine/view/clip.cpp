#include "engine/view/clip.h"

#include <algorithm>

#include "engine/base/range_probe.h"
#include "engine/base/table.h"
#include "engine/fixed/share.h"
#include "engine/view/project.h"

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

namespace {

/// part / whole of a line's length; whole > 0.
struct LinePart {
    ClipDistance part, whole;

    bool operator<(const LinePart& other) const {
        return compare_products(part.bits(), other.whole.bits(), other.part.bits(), whole.bits()) < 0;
    }
};

Vec3<View> place_along(const ViewLine& line, const LinePart& t) {
    return between(line.from, line.to, t.part, t.whole);
}

}  // namespace

ClipDistance half_distance(const ClipPlane& plane, const Vec3<View>& p) {
    return floor_shift(plane.distance(p), 1);
}

ViewVolume make_view_volume(const Frustum& frustum, View front, View back) {
    constexpr auto kOne = ClipNormal::from_int(1);
    const Vec3<ClipNormal> ahead{{}, {}, kOne};
    ViewVolume volume;
    std::copy(frustum.clip_planes.begin(), frustum.clip_planes.end(), volume.planes.begin());
    volume.planes[4] = {ahead, bounded_product(front, kOne)};
    volume.planes[5] = {-ahead, -bounded_product(back, kOne)};
    return volume;
}

/// With the ends at distances d0 and d1 from a plane, the line crosses it at t = d0 / (d0 - d1).
std::optional<ViewLine> clip_line(const ViewVolume& volume, const ViewLine& line) {
    constexpr ClipDistance kWhole = ClipDistance::ulp();
    LinePart enters{{}, kWhole}, leaves{kWhole, kWhole};
    for (const ClipPlane& plane : volume.planes) {
        const ClipDistance d0 = half_distance(plane, line.from), d1 = half_distance(plane, line.to);
        if (d0 < kOn && d1 < kOn) return {};
        if (d0 < kOn) enters = std::max(enters, LinePart{-d0, d1 - d0});
        if (d1 < kOn) leaves = std::min(leaves, LinePart{d0, d0 - d1});
    }
    if (leaves < enters) return {};
    return ViewLine{place_along(line, enters), place_along(line, leaves)};
}

std::optional<PixelLine> project_line(const ViewVolume& volume, const Projection& projection, const ViewLine& line) {
    const auto clipped = clip_line(volume, line);
    if (!clipped) return {};
    const auto pixel = [&](const Vec3<View>& place) {
        const ScreenPosition position = project(place, projection);
        const auto within = [](ScreenWide at, std::int32_t size_px) {
            return static_cast<std::int32_t>(std::clamp<std::int64_t>(floor_of(at), 0, size_px - 1));
        };
        return PixelPosition{within(position.x, projection.width_px), within(position.y, projection.height_px)};
    };
    return PixelLine{pixel(clipped->from), pixel(clipped->to)};
}

}  // namespace oblong

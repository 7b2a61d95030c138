#include "engine/frame/face_cover.h"

#include <algorithm>
#include <array>

#include "engine/frame/frame_context.h"
#include "engine/visibility/box_culler.h"

namespace oblong {

namespace {

/// The spans in these rows; spans are sorted by row.
std::span<const Span> spans_in_rows(std::span<const Span> spans, std::int32_t first, std::int32_t end) {
    const auto begin =
        std::partition_point(spans.begin(), spans.end(), [=](const Span& span) { return span.y < first; });
    const auto after = std::partition_point(begin, spans.end(), [=](const Span& span) { return span.y < end; });
    return {begin, after};
}

bool overlap(const Span& span, const ScreenRectangle& pixels) {
    return span.first < pixels.end_column && span.end > pixels.first_column && span.y >= pixels.first_row &&
           span.y < pixels.end_row;
}

/// Whether all of a face's plane in a rectangle is certainly nearer.
bool is_nearer(const LinearQuantity<InverseZ>& plane, const ScreenRectangle& pixels, InverseDepth nearest) {
    constexpr InverseZ kSteepest = InverseZ::from_int(1);  // steeper ones may overflow
    if (!is_within(plane.per_column, kSteepest) || !is_within(plane.per_row, kSteepest)) return false;
    const std::int32_t column = plane.per_column > InverseZ{} ? pixels.first_column : pixels.end_column - 1;
    const std::int32_t row = plane.per_row > InverseZ{} ? pixels.first_row : pixels.end_row - 1;
    return to_inverse_depth(plane.at(column, row)) > nearest;
}

/// Whether a pixel of a face in a rectangle is not nearer than `nearest`.
bool shows_farther(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z,
                   const ScreenRectangle& pixels, InverseDepth nearest) {
    if (is_nearer(inverse_z, pixels, nearest)) return false;
    for (const Span& span : spans_in_rows(spans, pixels.first_row, pixels.end_row)) {
        const std::int32_t first = std::max(span.first, pixels.first_column);
        const std::int32_t end = std::min(span.end, pixels.end_column);
        if (first >= end) continue;
        const InverseZ least = std::min(inverse_z.at(first, span.y), inverse_z.at(end - 1, span.y));
        if (to_inverse_depth(least) <= nearest) return true;
    }
    return false;
}

/// A lower bound of a face's 1/z: rounding moves a pixel's place on the face by less than two pixels.
InverseDepth farthest_inverse_depth_of(const VisibleFace& face) {
    const PlaneInverseZ& plane = face.inverse_z;
    const InverseZ farthest = reciprocal<InverseZ>(face.farthest_z);
    return to_inverse_depth(farthest - (absolute(plane.per_column) + absolute(plane.per_row)) * 2);
}

}  // namespace

bool FaceCover::hides(const LevelBox& box) {
    return hides(rectangle_of(box, frame_.view), nearest_inverse_depth_of(box, frame_.view));
}

bool FaceCover::hides(const ScreenRectangle& pixels, InverseDepth nearest) {
    const auto any_shows = [&](FaceList list) {
        const std::vector<VisibleFace>& faces = claims_.list(list);
        return std::any_of(faces.begin(), faces.end(), [&](const VisibleFace& face) {
            if (!overlap(face.bounds, pixels)) return false;
            const bool is_sky = list == FaceList::Sky;
            if (!is_sky && farthest_inverse_depth_of(face) > nearest) return false;
            return shows_farther(claims_.spans_of(face),
                                 is_sky ? LinearQuantity<InverseZ>{} : inverse_z_of(face, frame_), pixels, nearest);
        });
    };
    constexpr std::array kLists{FaceList::Sky, FaceList::Walls, FaceList::Flat, FaceList::Liquid, FaceList::Mirror};
    const auto is_free = [&](const Span& span) { return overlap(span, pixels); };
    return std::none_of(kLists.begin(), kLists.end(), any_shows) &&
           std::none_of(claims_.void_spans.begin(), claims_.void_spans.end(), is_free) &&
           std::none_of(claims_.torn.begin(), claims_.torn.end(),
                        [&](const TornSpan& torn) { return overlap(torn.span, pixels); });
}

InverseDepth nearest_inverse_depth_of(const LevelBox& box, const ViewContext& view) {
    const auto nearest = [&box](std::size_t axis, Unit forward) {
        return World::from_int(forward > Unit{} ? box.mins[axis] : box.maxs[axis]);
    };
    const Vec3<Unit>& forward = view.axes.forward;
    const View z =
        to_view({nearest(0, forward.x), nearest(1, forward.y), nearest(2, forward.z)}, view.eye, view.axes).z;
    return to_inverse_depth(reciprocal<InverseZ>(std::max(z, View::from_int(1))));
}

}  // namespace oblong

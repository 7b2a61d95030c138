#include "engine/frame/face_cover.h"

#include <algorithm>

#include "engine/frame/frame_context.h"
#include "engine/frame/view_scratch.h"
#include "engine/visibility/box_culler.h"

namespace oblong {

namespace {

/// Those of a face's spans, which are in order of rows, that are in these.
std::span<const Span> spans_in_rows(std::span<const Span> spans, std::int32_t first, std::int32_t end) {
    const auto begin =
        std::partition_point(spans.begin(), spans.end(), [=](const Span& span) { return span.y < first; });
    const auto after = std::partition_point(begin, spans.end(), [=](const Span& span) { return span.y < end; });
    return {begin, after};
}

/// How many pixels of a rectangle a face covers; none if some of them are no nearer than `nearest`.
std::optional<std::int64_t> pixels_nearer(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z,
                                          const ScreenRectangle& pixels, InverseDepth nearest) {
    std::int64_t count = 0;
    for (const Span& span : spans) {
        const std::int32_t first = std::max(span.first, pixels.first_column);
        const std::int32_t end = std::min(span.end, pixels.end_column);
        if (first >= end) continue;
        const InverseZ least = std::min(inverse_z.at(first, span.y), inverse_z.at(end - 1, span.y));
        if (to_inverse_depth(least) <= nearest) return std::nullopt;
        count += end - first;
    }
    return count;
}

}  // namespace

bool FaceCover::hides(const PlacedBox& place) const {
    const std::optional<ScreenRectangle> pixels = rectangle_of(place.box, frame_.view);
    return pixels && hides(*pixels, nearest_depth_of(place.box, frame_.view));
}

/// The farthest faces first: one of them shows, in most cases, that something is not hidden.
bool FaceCover::hides(const ScreenRectangle& pixels, InverseDepth nearest) const {
    std::int64_t left = std::int64_t{pixels.end_column - pixels.first_column} * (pixels.end_row - pixels.first_row);
    for (const FaceList list : {FaceList::Walls, FaceList::Flat, FaceList::Liquid, FaceList::Mirror}) {
        const std::vector<VisibleFace>& faces = scratch_.claims.list(list);
        for (auto face = faces.rbegin(); face != faces.rend(); ++face) {
            const auto all = scratch_.claims.spans_of(*face);
            if (all.front().y >= pixels.end_row || all.back().y < pixels.first_row) continue;
            const auto spans = spans_in_rows(all, pixels.first_row, pixels.end_row);
            const auto nearer = pixels_nearer(spans, inverse_z_of(*face, frame_), pixels, nearest);
            if (!nearer) return false;
            left -= *nearer;
        }
    }
    return left == 0;
}

InverseDepth nearest_depth_of(const LevelBox& box, const ViewContext& view) {
    const auto nearest = [&box](std::size_t axis, Unit forward) {
        return World::from_int(forward > Unit{} ? box.mins[axis] : box.maxs[axis]);
    };
    const Vec3<Unit>& forward = view.axes.forward;
    const View z =
        to_view({nearest(0, forward.x), nearest(1, forward.y), nearest(2, forward.z)}, view.eye, view.axes).z;
    return to_inverse_depth(reciprocal<InverseZ>(std::max(z, View::from_int(1))));
}

}  // namespace oblong

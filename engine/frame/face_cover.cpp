#include "engine/frame/face_cover.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/surface_pass.h"

namespace oblong {

namespace {

/// The first span not above a row; spans are sorted by row, and most faces have one in each.
const Span* first_from(std::int32_t row, std::span<const Span> spans) {
    const Span* const begin = spans.data();
    const std::int64_t guess = std::int64_t{row} - begin->y;
    if (guess <= 0) return begin;
    if (spans.back().y < row) return begin + spans.size();
    if (as_size(guess) < spans.size() && begin[guess].y == row && begin[guess - 1].y < row) return begin + guess;
    return std::partition_point(begin, begin + spans.size(), [row](const Span& span) { return span.y < row; });
}

/// The spans in these rows.
std::span<const Span> spans_in_rows(std::span<const Span> spans, std::int32_t first, std::int32_t end) {
    if (spans.empty()) return spans;
    const Span* const begin = first_from(first, spans);
    return {begin, std::max(begin, first_from(end, spans))};
}

/// Whether all of a face's plane in a rectangle is certainly nearer.
bool is_nearer(const LinearQuantity<InverseZ>& plane, const ScreenRectangle& pixels, InverseDepth nearest) {
    constexpr InverseZ kSteepest = InverseZ::from_int(1);  // steeper ones may overflow
    if (!is_within(plane.per_column, kSteepest) || !is_within(plane.per_row, kSteepest)) return false;
    const std::int32_t column = plane.per_column > InverseZ{} ? pixels.first_column : pixels.end_column - 1;
    const std::int32_t row = plane.per_row > InverseZ{} ? pixels.first_row : pixels.end_row - 1;
    return to_inverse_depth(plane.at(column, row)) > nearest;
}

/// Whether a pixel of a span in an outline is not nearer than `nearest`.
inline bool shows_farther(const Span& span, const LinearQuantity<InverseZ>& inverse_z, const ScreenOutline& outline,
                          InverseDepth nearest) {
    const auto [first, end] = outline.columns_in(span.y, span.first, span.end);
    if (first >= end) return false;
    const InverseZ least = std::min(inverse_z.at(first, span.y), inverse_z.at(end - 1, span.y));
    return to_inverse_depth(least) <= nearest;
}

/// A lower bound of a face's 1/z: rounding moves a pixel's place on the face by less than two pixels.
InverseDepth farthest_inverse_depth_of(const VisibleFace& face) {
    const PlaneInverseZ& plane = face.inverse_z;
    const InverseZ farthest = reciprocal<InverseZ>(face.farthest_z);
    return to_inverse_depth(farthest - (absolute(plane.per_column) + absolute(plane.per_row)) * 2);
}

/// The spans of a face that may be in an outline, without those of which all pixels there are certainly nearer.
inline std::span<const Span> spans_in_question(const OpenFace& face, const ScreenOutline& outline,
                                               InverseDepth nearest) {
    if (!overlap(face.pixels, outline.pixels)) return {};
    const ScreenRectangle both = intersection(face.pixels, outline.pixels);
    if (is_nearer(face.inverse_z, both, nearest)) return {};
    return spans_in_rows(face.spans, both.first_row, both.end_row);
}

/// Whether a face shows a pixel in an outline that is not nearer than `nearest`.
inline bool shows_farther(const OpenFace& face, const ScreenOutline& outline, InverseDepth nearest) {
    for (const Span& span : spans_in_question(face, outline, nearest))
        if (shows_farther(span, face.inverse_z, outline, nearest)) return true;
    return false;
}

/// A rectangle around the spans that show such pixels; empty if there are none.
ScreenRectangle rectangle_around_open(const OpenFace& face, const ScreenOutline& outline, InverseDepth nearest) {
    ScreenRectangle around{};
    for (const Span& span : spans_in_question(face, outline, nearest)) {
        if (!shows_farther(span, face.inverse_z, outline, nearest)) continue;
        const ScreenRectangle pixels{span.first, span.end, span.y, span.y + 1};
        around = is_empty(around) ? pixels : joined(around, pixels);
    }
    return intersection(around, face.pixels);
}

}  // namespace

bool FaceCover::begin(const ScreenRectangle& pixels, InverseDepth nearest, Hidden hidden) {
    open_.clear();
    around_ = pixels;
    const auto add = [&](std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z,
                         const ScreenRectangle& bounds) {
        const OpenFace face{spans, inverse_z, intersection(bounds, pixels)};
        // After the first that is open, others are kept that may be.
        if (!open_.empty() || shows_farther(face, {pixels}, nearest)) open_.push_back(face);
    };
    for (const VisibleFace& face : claims_.list(FaceList::Sky))
        if (overlap(face.bounds, pixels)) add(claims_.spans_of(face), {}, face.bounds);
    for (const FaceList list : {FaceList::Walls, FaceList::Flat, FaceList::Liquid, FaceList::Mirror}) {
        if (hidden == Hidden::ExceptOverSky) break;
        for (const VisibleFace& face : claims_.list(list)) {
            if (!overlap(face.bounds, pixels)) continue;
            const LinearQuantity<InverseZ> inverse_z = inverse_z_of(face, frame_);
            if (is_nearer(inverse_z, intersection(face.bounds, pixels), nearest)) continue;
            if (farthest_inverse_depth_of(face) <= nearest) add(claims_.spans_of(face), inverse_z, face.bounds);
        }
    }
    if (!claims_.void_spans.empty()) add(claims_.void_spans, {}, pixels);
    for (const TornSpan& torn : claims_.torn) add({&torn.span, 1}, {}, pixels);
    return !open_.empty();
}

bool FaceCover::shows(const ScreenOutline& outline, InverseDepth nearest) const {
    if (!overlap(around_, outline.pixels)) return false;
    for (const OpenFace& face : open_)
        if (shows_farther(face, outline, nearest)) return true;
    return false;
}

bool FaceCover::narrow(const ScreenOutline& outline, InverseDepth nearest) {
    std::erase_if(open_, [&](OpenFace& face) {
        face.pixels = rectangle_around_open(face, outline, nearest);
        return is_empty(face.pixels);
    });
    for (const OpenFace& face : open_) around_ = &face == open_.data() ? face.pixels : joined(around_, face.pixels);
    return !open_.empty();
}

}  // namespace oblong

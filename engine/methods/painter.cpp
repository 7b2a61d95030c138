#include "engine/methods/painter.h"

#include <algorithm>
#include <numeric>

#include "engine/base/table.h"

namespace oblong {

namespace {

/// Twice the mean, or twice the farthest.
View doubled_depth(const ScannedFace& face, SortDepth depth) {
    return face.farthest_z + (depth == SortDepth::Mean ? face.nearest_z : face.farthest_z);
}

void paint_face(std::int32_t index, const ScannedFaces& scanned, PixelOwners& owners) {
    for (const Span& span : scanned.spans_of(item(scanned.faces, index))) {
        std::fill(owners.row(span.y) + span.first, owners.row(span.y) + span.end, index);
        owners.counts.pixels_written += span.end - span.first;
    }
}

/// The position of each face in an order, and of kNone before all.
std::vector<std::int32_t> places_in(std::span<const std::int32_t> order) {
    std::vector<std::int32_t> places(order.size() + 1, PixelOwners::kNone);
    for (std::size_t place = 0; place < order.size(); ++place)
        item(places, order[place] + 1) = static_cast<std::int32_t>(place);
    return places;
}

}  // namespace

std::vector<std::int32_t> back_to_front_by_tree(const ScannedFaces& scanned) {
    std::vector<std::int32_t> order(scanned.faces.size());
    std::iota(order.rbegin(), order.rend(), 0);
    return order;
}

std::vector<std::int32_t> back_to_front_by_depth(const ScannedFaces& scanned, SortDepth depth,
                                                 std::int64_t& comparisons) {
    std::vector<std::int32_t> order = back_to_front_by_tree(scanned);
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        ++comparisons;
        return doubled_depth(item(scanned.faces, a), depth) > doubled_depth(item(scanned.faces, b), depth);
    });
    return order;
}

void find_owners_by_painting(const ScannedFaces& scanned, std::span<const std::int32_t> back_to_front,
                             PixelOwners& owners) {
    for (const std::int32_t face : back_to_front)
        if (!item(scanned.faces, face).is_seen_through) paint_face(face, scanned, owners);
    const std::vector<std::int32_t> places = places_in(back_to_front);
    for (const std::int32_t index : back_to_front) {
        const ScannedFace& face = item(scanned.faces, index);
        if (!face.is_seen_through) continue;
        for (const Span& span : scanned.spans_of(face))
            for (std::int32_t column = span.first; column < span.end; ++column)
                if (item(places, owners.row(span.y)[column] + 1) < item(places, index + 1))
                    append_pixel(index, column, span.y, owners.seen);
    }
}

}  // namespace oblong

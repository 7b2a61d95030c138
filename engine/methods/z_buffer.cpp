#include "engine/methods/z_buffer.h"

#include <algorithm>
#include <numeric>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"

namespace oblong {

namespace {

/// Indices into `scanned`, ordered by the faces' index in the level.
std::vector<std::int32_t> in_file_order(const ScannedFaces& scanned) {
    std::vector<std::int32_t> order(scanned.faces.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        return item(scanned.faces, a).face < item(scanned.faces, b).face;
    });
    return order;
}

void draw_face(std::int32_t index, const ScannedFaces& scanned, std::vector<InverseZ>& depths, PixelOwners& owners) {
    const ScannedFace& face = item(scanned.faces, index);
    const FaceDepth depth(face);
    for (const Span& span : scanned.spans_of(face)) {
        std::int32_t* const owner = owners.row(span.y);
        InverseZ* const nearest = depths.data() + std::int64_t{span.y} * owners.width_px;
        owners.counts.pixels_tested += span.end - span.first;
        for (std::int32_t column = span.first; column < span.end; ++column) {
            const InverseZ here = depth.at(column, span.y);
            if (here <= nearest[column]) continue;
            ++owners.counts.pixels_written;
            nearest[column] = here;
            owner[column] = index;
        }
    }
}

/// Adds the pixels where a transparent face is nearer than the owner.
void see_face(std::int32_t index, const ScannedFaces& scanned, const std::vector<InverseZ>& depths,
              PixelOwners& owners) {
    const ScannedFace& face = item(scanned.faces, index);
    const FaceDepth depth(face);
    for (const Span& span : scanned.spans_of(face)) {
        const InverseZ* const nearest = depths.data() + std::int64_t{span.y} * owners.width_px;
        owners.counts.pixels_tested += span.end - span.first;
        for (std::int32_t column = span.first; column < span.end; ++column)
            if (depth.at(column, span.y) > nearest[column]) append_pixel(index, column, span.y, owners.seen);
    }
}

}  // namespace

FaceDepth::FaceDepth(const ScannedFace& face)
    : inverse_z_(face.inverse_z),
      farthest_(reciprocal<InverseZ>(std::max(face.farthest_z, View::ulp()))),
      nearest_(reciprocal<InverseZ>(std::max(face.nearest_z, View::ulp()))) {}

InverseZ FaceDepth::at(std::int32_t column, std::int32_t row) const {
    return std::clamp(inverse_z_.at(column, row), farthest_, nearest_);
}

void find_owners_by_z_buffer(const ScannedFaces& scanned, std::vector<InverseZ>& depths, PixelOwners& owners) {
    depths.assign(owners.faces.size(), InverseZ{});
    const std::vector<std::int32_t> order = in_file_order(scanned);
    for (const std::int32_t face : order)
        if (!item(scanned.faces, face).is_seen_through) draw_face(face, scanned, depths, owners);
    for (const std::int32_t face : order)
        if (item(scanned.faces, face).is_seen_through) see_face(face, scanned, depths, owners);
}

}  // namespace oblong

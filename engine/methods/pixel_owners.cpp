#include "engine/methods/pixel_owners.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/fixed/wide.h"

namespace oblong {

void PixelOwners::start(std::int32_t width, std::int32_t height) {
    width_px = width;
    height_px = height;
    faces.assign(pixel_count(width, height), kNone);
    seen.clear();
    counts = {};
}

void add_face(ScannedFace face, const ScanlineExtents& rows, std::int32_t width_px,
              std::span<const Vec3<World>> corners, const Vec3<World>& eye, ScannedFaces& scanned) {
    face.first_span = static_cast<std::uint32_t>(scanned.spans.size());
    for (std::int32_t y = rows.first; y < rows.end; ++y) {
        const std::int32_t first = std::max(item(rows.left, y), 0), end = std::min(item(rows.right, y), width_px);
        if (first < end) scanned.spans.push_back({y, first, end});
    }
    face.span_count = static_cast<std::uint32_t>(scanned.spans.size()) - face.first_span;
    face.first_corner = static_cast<std::uint32_t>(scanned.from_eye.size());
    face.corner_count = static_cast<std::uint32_t>(corners.size());
    for (const Vec3<World>& corner : corners) scanned.from_eye.push_back(widening_difference(corner, eye));
    scanned.faces.push_back(face);
}

void append_pixel(std::int32_t face, std::int32_t column, std::int32_t row, std::vector<OwnedRun>& runs) {
    if (!runs.empty() && runs.back().face == face && runs.back().span.y == row && runs.back().span.end == column)
        ++runs.back().span.end;
    else
        runs.push_back({face, {row, column, column + 1}});
}

namespace {

/// Joins runs that continue each other.
void join_runs(std::vector<OwnedRun>& runs) {
    std::size_t count = 0;
    for (const OwnedRun& run : runs) {
        OwnedRun* const last = count > 0 ? &runs[count - 1] : nullptr;
        if (last && last->face == run.face && last->span.y == run.span.y && last->span.end == run.span.first)
            last->span.end = run.span.end;
        else
            runs[count++] = run;
    }
    runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(count), runs.end());
}

}  // namespace

std::vector<OwnedRun> owned_runs(const PixelOwners& owners) {
    std::vector<OwnedRun> runs;
    for (std::int32_t y = 0; y < owners.height_px; ++y) {
        const std::int32_t* const row = owners.row(y);
        for (std::int32_t column = 0; column < owners.width_px; ++column)
            if (row[column] != PixelOwners::kNone) append_pixel(row[column], column, y, runs);
    }
    runs.insert(runs.end(), owners.seen.begin(), owners.seen.end());
    std::stable_sort(runs.begin(), runs.end(), [](const OwnedRun& a, const OwnedRun& b) { return a.face < b.face; });
    join_runs(runs);
    return runs;
}

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

namespace {

/// Where a ray meets a plane: t = distance / approach, both above 0.
struct RayHit {
    PlaneDistance distance;
    Sine60 approach;

    bool is_before(const RayHit& other) const {
        const auto size = [](auto value) { return std::uint64_t{value.bits()}; };
        return compare_products(size(distance), size(other.approach), size(other.distance), size(approach)) < 0;
    }
};

void add_target(std::int32_t index, const ScannedFaces& scanned, std::vector<Vec3<Unit>>& directions,
                RayTargets& targets) {
    const ScannedFace& face = item(scanned.faces, index);
    if (face.eye_distance <= PlaneDistance{}) return;
    directions.clear();
    for (const Vec3<WorldWide>& corner : scanned.corners_of(face)) directions.push_back(normalised(corner));
    const auto first_edge = static_cast<std::uint32_t>(targets.edges.size());
    Vec3<Unit> from = directions.back();
    for (const Vec3<Unit>& to : directions) {
        targets.edges.push_back(normalised(cross(from, to)));
        from = to;
    }
    (face.is_seen_through ? targets.seen_through : targets.opaque)
        .push_back({index, face.normal, face.eye_distance, first_edge, face.corner_count});
}

bool is_inside(const Vec3<Unit>& ray, std::span<const Vec3<Unit>> edges) {
    return std::all_of(edges.begin(), edges.end(), [&](const Vec3<Unit>& edge) { return dot(edge, ray) >= Sine60{}; });
}

/// Where the ray hits a target nearer than `nearest`, if it does.
std::optional<RayHit> hit(const RayTarget& target, const Vec3<Unit>& ray, const std::optional<RayHit>& nearest,
                          const RayTargets& targets) {
    const RayHit meeting{target.eye_distance, -dot(target.normal, ray)};
    if (meeting.approach <= Sine60{}) return std::nullopt;
    if (!is_inside(ray, std::span(targets.edges).subspan(target.first_edge, target.edge_count))) return std::nullopt;
    return nearest && !meeting.is_before(*nearest) ? std::nullopt : std::optional(meeting);
}

void cast(const Vec3<Unit>& ray, std::int32_t column, std::int32_t row, const RayTargets& targets,
          PixelOwners& owners) {
    std::optional<RayHit> nearest;
    for (const RayTarget& target : targets.opaque)
        if (const auto meeting = hit(target, ray, nearest, targets)) {
            nearest = meeting;
            owners.row(row)[column] = target.face;
        }
    for (const RayTarget& target : targets.seen_through)
        if (hit(target, ray, nearest, targets)) append_pixel(target.face, column, row, owners.seen);
    owners.counts.ray_face_tests += std::ssize(targets.opaque) + std::ssize(targets.seen_through);
}

}  // namespace

void find_owners_by_rays(const ScannedFaces& scanned, const ViewDirections& directions, RayTargets& targets,
                         PixelOwners& owners) {
    targets.clear();
    std::vector<Vec3<Unit>> corners;
    for (std::int32_t face = 0; face < std::ssize(scanned.faces); ++face) add_target(face, scanned, corners, targets);
    for (std::int32_t row = 0; row < owners.height_px; ++row)
        for (std::int32_t column = 0; column < owners.width_px; ++column)
            cast(normalised(directions.at(column, row)), column, row, targets, owners);
}

}  // namespace oblong

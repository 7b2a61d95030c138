#include "engine/methods/ray_casting.h"

#include <algorithm>
#include <optional>

#include "engine/base/table.h"
#include "engine/fixed/wide.h"

namespace oblong {

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
        for (std::int32_t column = 0; column < owners.width_px; ++column) {
            const Vec3<DirectionPart> through_centre{directions.x.at(column, row), directions.y.at(column, row),
                                                     directions.z.at(column, row)};
            cast(normalised(through_centre), column, row, targets, owners);
        }
}

}  // namespace oblong

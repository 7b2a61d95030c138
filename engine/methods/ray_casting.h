#pragma once

#include "engine/methods/pixel_owners.h"
#include "engine/view/gradients.h"

namespace oblong {

/// A face as a target of rays: its plane, and the planes through the eye and each of its edges.
struct RayTarget {
    std::int32_t face;  ///< in ScannedFaces::faces
    Vec3<Unit> normal;
    PlaneDistance eye_distance;  ///< above 0
    std::uint32_t first_edge, edge_count;
};

/// The faces that rays from one eye may hit.
struct RayTargets {
    std::vector<RayTarget> opaque, seen_through;
    std::vector<Vec3<Unit>> edges;  ///< normals of the planes through eye and edge, inward

    void clear() {
        opaque.clear();
        seen_through.clear();
        edges.clear();
    }
};

/// Ray casting, the naive method (Princeton, "Ray casting revisited"): a ray from the eye through the centre of each
/// pixel is tested against every face; the nearest hit owns the pixel. No face is clipped, projected or scanned, and
/// pixels share no work.
///
/// A ray p(t) = eye + t d meets a plane at t = distance / -(N . d), and hits the face if the point is on the inner side
/// of each edge's plane or on it. Values of t are compared exactly, without a division. d and the edges' normals are
/// rounded to 2^-30, a millionth of a pixel; corners are not rounded, so pixels may differ from those of a projecting
/// method where the ray passes within 1/256 pixel of an edge. `targets` is scratch.
void find_owners_by_rays(const ScannedFaces& scanned, const ViewDirections& directions, RayTargets& targets,
                         PixelOwners& owners);

}  // namespace oblong

#pragma once

#include <optional>

#include "engine/level/level.h"
#include "engine/level/side.h"
#include "engine/view/view_context.h"

namespace oblong {

/// The eye's position and its leaf.
struct PlacedEye {
    Vec3<World> position;
    LeafIndex leaf;
};

/// Moves an eye that is nearer than 2 steps of World (1/2,048 unit) to a plane of its leaf to that distance: an eye in
/// the plane of a face sees it neither from the front nor from the back, and half the screen would stay empty (hard
/// case V11). A point on a plane belongs to its back (find_leaf) and is moved to the back, or to the front if only the
/// back is solid. At an edge or a corner too sharp for this, it is moved to the first place of find_clear_place().
PlacedEye place_eye(const Level& level, Vec3<World> eye);

/// The first place that is not solid and 2 steps clear of all planes, on the surfaces of cubes that reach 16, 32, 64
/// and 128 steps (1/32 unit) to each side of the eye: 33 places an edge, in the order of x, then y, then z. For wedges
/// so sharp that moving off one plane leads through the other.
std::optional<PlacedEye> find_clear_place(const Level& level, const Vec3<World>& eye);

/// How far in front of a plane the viewpoint is: normal . position - w distance. For a direction (w = 0): 2^14 units
/// times the cosine of its angle to the normal, positive where it comes from the front.
inline PlaneDistance plane_distance(const LevelPlane& plane, const Viewpoint& viewpoint) {
    const PlaneDistance part_of_plane = PlaneDistance::from_raw(plane.distance.raw & viewpoint.weight_mask);
    const PlaneDistance distance = dot(viewpoint.position, plane.normal) - part_of_plane;
    note_range<"plane distance">(distance);
    return distance;
}

}  // namespace oblong

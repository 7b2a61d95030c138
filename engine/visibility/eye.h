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

/// Moves an eye that lies within 2 steps of World (1/2,048 unit) of a plane that bounds its leaf to that distance from
/// it: an eye in the plane of a face sees it neither from the front nor from the back, and half the screen would stay
/// empty (hard case V11). A point on a plane belongs to the back of it (find_leaf), and is moved to the back; to the
/// front if the back is solid and the front is not. On an edge or in a corner so sharp that there is no such place next
/// to it: to the first found within 1/32 unit.
PlacedEye place_eye(const Level& level, Vec3<World> eye);

/// The first place 2 steps clear of all planes and not solid on the surfaces of cubes that reach 16, 32, 64 and 128
/// steps to each side of the eye, 33 places an edge, in the order of x, then y, then z: for the edges of wedges so
/// sharp that the way off one of their planes leads through the other.
std::optional<PlacedEye> find_clear_place(const Level& level, const Vec3<World>& eye);

/// How far in front of a plane the viewpoint is: normal . position - w distance. Of a direction the sign says which
/// side of all such planes it comes from, and the size how steeply: 2^14 units where it is at right angles.
inline PlaneDistance plane_distance(const LevelPlane& plane, const Viewpoint& viewpoint) {
    const PlaneDistance part_of_plane = PlaneDistance::from_raw(plane.distance.raw & viewpoint.weight_mask);
    const PlaneDistance distance = dot(viewpoint.position, plane.normal) - part_of_plane;
    note_range<"plane distance">(distance);
    return distance;
}

}  // namespace oblong

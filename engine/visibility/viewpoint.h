#pragma once

#include "engine/level/side.h"
#include "engine/view/view_context.h"

namespace oblong {

/// How far in front of a plane the viewpoint is: normal . position - w distance. Of a direction the sign says which
/// side of all such planes it comes from, and the size how steeply: 2^14 units where it is at right angles.
inline PlaneDistance plane_distance(const LevelPlane& plane, const Viewpoint& viewpoint) {
    const PlaneDistance part_of_plane = PlaneDistance::from_raw(plane.distance.raw & viewpoint.weight_mask);
    const PlaneDistance distance = dot(viewpoint.position, plane.normal) - part_of_plane;
    note_range<"plane distance">(distance);
    return distance;
}

}  // namespace oblong

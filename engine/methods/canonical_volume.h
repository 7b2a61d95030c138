#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/math/matrix.h"
#include "engine/view/projection.h"
#include "engine/view/views.h"

namespace oblong {

/// The six sides of the canonical view volume, -w <= x <= w, -w <= y <= w, 0 <= z <= w, in homogeneous coordinates. The
/// matrix of a view with a near and a far plane maps its volume to this one, so that clipping only compares
/// coordinates.
enum class VolumeSide : std::uint8_t { Left, Right, Bottom, Top, Near, Far };
inline constexpr int kVolumeSideCount = 6;

/// How far a point is inside of a side: w + x, w - x, w + y, w - y, z, w - z; a point on it is inside. Coordinates of
/// less than 2^29.
Entry distance_inside(const Vec4& point, VolumeSide side);

/// A bit for each side that the point is outside of, in the order of VolumeSide (Cohen and Sutherland).
unsigned volume_outcode(const Vec4& point);

/// Both parts of a convex polygon cut by a side, each with the two corners on the side; a corner on it belongs to the
/// inside. A part may be empty. Crossings are computed from an edge's inside end, so that neighbours get the same ones.
/// Coordinates of less than 2^29.
struct SplitPolygon {
    std::vector<Vec4> inside, outside;
};
SplitPolygon split_polygon(const std::vector<Vec4>& polygon, VolumeSide side);

/// The part of a convex polygon that is in the volume, clipped by one side after the other (Sutherland and Hodgman).
/// Any coordinates: points of more than 2^29 are scaled down first, which does not change the points that they
/// represent.
std::vector<Vec4> clip_to_volume(const std::vector<Vec4>& polygon);

/// Viewspace to the canonical volume of a perspective view between depths `nearest` and `farthest` (above 0, the second
/// larger): x and y by the projection's two multipliers over half the size in pixels, z by lambda = far / (far - near)
/// (course notes), w = z.
Matrix4 volume_matrix(const Projection& projection, Entry nearest, Entry farthest);

/// The steps of the lab sheet from the world to its canonical view volume, -z <= x <= z, -z <= y <= z, z <= 1, in their
/// order: the view reference point to the origin, the view's axes onto x, y and z, the centre of projection to the
/// origin, a shear that brings the window's middle onto z, a scale. A perspective view with a back plane.
std::array<Matrix4, 5> lab_volume_steps(const WindowView& window);

/// The screen position of a point in the volume, in pixels, y down: perspective divide and viewport. `point` has w
/// above 0.
struct VolumeScreenPoint {
    Entry x, y, depth;  ///< depth: 0 on the near side, 1 on the far one
};
VolumeScreenPoint volume_to_screen(const Vec4& point, std::int32_t width_px, std::int32_t height_px);

}  // namespace oblong

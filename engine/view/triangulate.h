#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/vec.h"

namespace oblong {

/// Three corners of a polygon by number, in the polygon's own order.
using CornerTriple = std::array<std::uint32_t, 3>;

/// The triangles of a convex polygon that all share its first corner (course notes): (0, i + 1, i + 2), two fewer than
/// it has corners.
std::vector<CornerTriple> triangulate_as_fan(std::size_t corner_count);

/// The triangles of a convex polygon around a point in its middle, which becomes corner number `corner_count`: as many
/// as it has corners, and rounder ones than a fan's.
std::vector<CornerTriple> triangulate_around_middle(std::size_t corner_count);
/// That point: the mean of the corners, rounded once. At least one corner.
Vec3<World> middle_of(std::span<const Vec3<World>> corners);

/// The triangles between diagonals, lines from a corner to one that is not adjacent: an ear, a corner whose diagonal
/// lies inside the polygon, is cut off again and again (Meisters). For polygons that are convex or concave, in a plane
/// or nearly; two fewer than corners. Decided exactly, as seen along the axis that the polygon faces most. A polygon
/// that crosses itself gets as many triangles, which then overlap.
std::vector<CornerTriple> triangulate_by_diagonals(std::span<const Vec3<World>> corners);

}  // namespace oblong

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/vec.h"

namespace oblong {

/// The numbers of three corners, in the polygon's order.
using CornerTriple = std::array<std::uint32_t, 3>;

/// Triangulates a convex or concave polygon, planar or nearly so, by repeatedly cutting off an ear, a corner whose
/// diagonal lies inside the polygon (Meisters). Gives two triangles fewer than corners. Decides exactly, in the
/// projection along the axis that the polygon faces most. The triangles of a polygon that crosses itself overlap.
std::vector<CornerTriple> triangulate_by_diagonals(std::span<const Vec3<World>> corners);

}  // namespace oblong

#pragma once

#include <cstdint>
#include <vector>

#include "engine/math/vec.h"
#include "engine/mesh/triangulate.h"
#include "engine/view/clip.h"
#include "engine/view/projection.h"

namespace oblong {

/// The triangles of a convex polygon that all share its first corner (course notes): (0, i + 1, i + 2), two fewer than
/// it has corners.
std::vector<CornerTriple> triangulate_as_fan(std::size_t corner_count);

/// The triangles of a convex polygon around a point in its middle (middle_of), which becomes corner number
/// `corner_count`: as many as it has corners, and rounder ones than a fan's.
std::vector<CornerTriple> triangulate_around_middle(std::size_t corner_count);

/// Whether a face turns its back to the eye, in any space that all three are given in (Abrash: before any transform, by
/// one dot product). `normal` is of length 1 and points to the face's front; `point` is any point of it. A face seen
/// edge-on counts as turned away.
constexpr bool faces_away(const Vec3<World>& point, const Vec3<Unit>& normal, const Vec3<World>& eye) {
    return dot(widening_difference(point, eye), normal) >= PlaneDistance{};
}

/// The same from the normal alone: whether it points along the view, its z in viewspace not below 0. Right for parallel
/// projections only. In perspective the rays to the faces differ: one beside the view's middle may face the eye though
/// its normal points away (Abrash's figure 3), and the other way around. Here to be compared.
constexpr bool normal_points_away(const Vec3<Unit>& normal, const Vec3<Unit>& forward) {
    return dot(normal, forward) >= Sine60{};
}

/// PolygonClipper::clip_to_plane() from `in` to `out`.
void clip_to_plane(const ClipPlane& plane, std::uint8_t border, const std::vector<ClipVertex>& in,
                   std::vector<ClipVertex>& out);

}  // namespace oblong

#pragma once

#include "engine/math/vec.h"
#include "engine/view/projection.h"

namespace oblong {

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

}  // namespace oblong

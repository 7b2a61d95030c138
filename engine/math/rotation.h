#pragma once

#include "engine/fixed/angle.h"
#include "engine/math/basis.h"
#include "engine/math/vec.h"

namespace oblong {

/// A direction turned about an axis of length 1, counter-clockwise as seen with the axis pointing at the viewer (in
/// right-handed axes). Rodrigues' formula, rounded once.
Vec3<Unit> rotate_about_axis(const Vec3<Unit>& direction, const Vec3<Unit>& axis, Angle angle);
Basis rotate_about_axis(const Basis& basis, const Vec3<Unit>& axis, Angle angle);

/// Rotation by projection onto axes (Abrash): the direction's coordinates along right, up and forward.
Vec3<Unit> project_onto_axes(const Vec3<Unit>& direction, const Basis& axes);
/// Its inverse: the direction that has these coordinates along right, up and forward.
Vec3<Unit> sum_along_axes(const Vec3<Unit>& coordinates, const Basis& axes);

}  // namespace oblong

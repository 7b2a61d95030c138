#pragma once

#include "engine/base/range_probe.h"
#include "engine/fixed/fixed.h"
#include "engine/fixed/sine_methods.h"
#include "engine/fixed/trig.h"
#include "engine/math/vec.h"

namespace oblong {

/// The axes of a view in world coordinates, an orthonormal basis.
struct Basis {
    Vec3<Unit> right, up, forward;
    constexpr bool operator==(const Basis&) const = default;
};

/// The view's axes in the world (x east, y north, z up, right-handed): yaw counter-clockwise from +x seen from above,
/// then pitch, positive looking down, then roll, positive leaning right. At 0, 0, 0: forward = +x, right = -y, up = +z.
/// Each component is within 0.51 steps of 2^-30 of the exact rotation by these binary angles; methods other than
/// NearestStep add the errors of their sines.
Basis view_basis(Angle yaw, Angle pitch, Angle roll, SineMethod method = SineMethod::NearestStep);

/// The axes rounded to fewer fraction bits, 6 to 30.
Basis rounded_to(const Basis& basis, std::int32_t fraction_bits);

/// A coordinate along an axis, rounded once. No world position overflows: the difference has 33 bits, and by Cauchy's
/// inequality the sum is below sqrt(3) 2^62 + 2^25.
template <class Int>
constexpr View view_coordinate(const Vec3<Fixed<Int, 12>>& from_eye, const Vec3<Unit>& axis) {
    const PlaneDistance along = dot(from_eye, axis);
    note_range<"axis . (p - eye)">(along);
    const auto coordinate = convert<View>(along);
    note_range<"view position">(coordinate);
    return coordinate;
}

/// World to viewspace: x right, y up, z forward from `world_eye`.
constexpr Vec3<View> to_view(const Vec3<World>& world_point, const Vec3<World>& world_eye, const Basis& basis) {
    const auto in_view = [&basis](const auto& from_eye) {
        return Vec3<View>{view_coordinate(from_eye, basis.right), view_coordinate(from_eye, basis.up),
                          view_coordinate(from_eye, basis.forward)};
    };
    Vec3<World> near;
    if (native::kHasShortRegisters && !__builtin_sub_overflow(world_point.x.raw, world_eye.x.raw, &near.x.raw) &&
        !__builtin_sub_overflow(world_point.y.raw, world_eye.y.raw, &near.y.raw) &&
        !__builtin_sub_overflow(world_point.z.raw, world_eye.z.raw, &near.z.raw))
        return in_view(near);
    return in_view(widening_difference(world_point, world_eye));
}

enum class Handedness { Right, Left };

/// The axes of a view from `world_eye` to `world_target` with up as near to `up_hint` as possible (course notes).
/// `handedness` is the world's. Always orthonormal: if eye and target are equal, forward is perpendicular to the hint;
/// if the view is along the hint, or the hint is zero, up is some vector perpendicular to forward.
Basis look_at(const Vec3<World>& world_eye, const Vec3<World>& world_target, const Vec3<Unit>& up_hint,
              Handedness handedness = Handedness::Right);

}  // namespace oblong

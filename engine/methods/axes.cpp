#include "engine/methods/axes.h"

#include <algorithm>
#include <array>

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/wide.h"

namespace oblong {

namespace {

constexpr Sine60 kOne60 = Sine60::from_int(1);

/// v - axis (axis . v), with 60 fraction bits.
Vec3<Sine60> without(const Vec3<Unit>& v, const Vec3<Unit>& axis) {
    const Sine60 along = dot(axis, v);
    const auto rest = [&along](Unit component, Unit of_axis) {
        return convert<Sine60>(component) - product<Sine60>(of_axis, along);
    };
    return {rest(v.x, axis.x), rest(v.y, axis.y), rest(v.z, axis.z)};
}

/// The direction of `v` without its part along `axis`; any perpendicular direction if nothing is left.
Vec3<Unit> direction_without(const Vec3<Unit>& v, const Vec3<Unit>& axis) {
    const Vec3<Unit> once = normalised(without(v, axis));
    if (once == Vec3<Unit>{}) return perpendicular_to(axis);
    // For nearly parallel directions the remainder is small and its rounding errors are relatively large: a second pass
    // removes them.
    return normalised(without(once, axis));
}

}  // namespace

FineBasis y_up_fine_basis(Angle yaw, Angle pitch, Angle roll) {
    const auto [sy, cy] = sine_cosine(yaw);
    const auto [sp, cp] = sine_cosine(pitch);
    const auto [sr, cr] = sine_cosine(roll);
    const Sine60 sr_sp = multiply(sr, sp), cr_sp = multiply(cr, sp);
    return {
        .right = {multiply(cr, cy) - multiply(sr_sp, sy), multiply(sr, cp), -multiply(cr, sy) - multiply(sr_sp, cy)},
        .up = {-multiply(cr_sp, sy) - multiply(sr, cy), multiply(cr, cp), multiply(sr, sy) - multiply(cr_sp, cy)},
        .forward = {multiply(cp, sy), sp, multiply(cp, cy)}};
}

Basis y_up_basis(Angle yaw, Angle pitch, Angle roll) {
    const FineBasis fine = y_up_fine_basis(yaw, pitch, roll);
    return {.right = convert<Unit>(fine.right), .up = convert<Unit>(fine.up), .forward = convert<Unit>(fine.forward)};
}

Sine60 orthonormal_flaw(const Basis& basis) {
    const std::array axes{basis.right, basis.up, basis.forward};
    Sine60 worst;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        worst = std::max(worst, absolute(dot(axes[i], axes[i]) - kOne60));
        worst = std::max(worst, absolute(dot(axes[i], axes[(i + 1) % axes.size()])));
    }
    return worst;
}

bool is_orthonormal(const Basis& basis) {
    return orthonormal_flaw(basis) <= kOrthonormalFlaw;
}

Basis orthonormalised(const Basis& basis) {
    Basis result;
    result.forward = normalised(basis.forward);
    if (result.forward == Vec3<Unit>{}) result.forward = perpendicular_to({});
    result.up = direction_without(basis.up, result.forward);
    const Vec3<Unit> right = normalised(cross(result.forward, result.up));
    result.right = dot(right, basis.right) < Sine60{} ? -right : right;
    return result;
}

}  // namespace oblong

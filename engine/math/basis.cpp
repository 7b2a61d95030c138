#include "engine/math/basis.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/wide.h"
#include "engine/math/vec.h"

namespace oblong {

namespace {

Vec3<Unit> rounded(Sine60 x, Sine60 y, Sine60 z) {
    return {convert<Unit>(x), convert<Unit>(y), convert<Unit>(z)};
}

Vec3<Unit> direction_between(const Vec3<World>& from, const Vec3<World>& to) {
    return normalised(widening_difference(to, from));
}

constexpr Sine60 kOne60 = Sine60::from_int(1);

/// v - axis (axis . v), with 60 fraction bits.
Vec3<Sine60> without(const Vec3<Unit>& v, const Vec3<Unit>& axis) {
    const Sine60 along = dot(axis, v);
    const auto rest = [&along](Unit component, Unit of_axis) {
        return convert<Sine60>(component) - Sine60::from_raw(mul_shift(of_axis.raw, along.raw, Unit::kFractionBits));
    };
    return {rest(v.x, axis.x), rest(v.y, axis.y), rest(v.z, axis.z)};
}

/// The direction of `v` without its part along `axis`; any direction at right angles to the axis where nothing is left.
Vec3<Unit> direction_without(const Vec3<Unit>& v, const Vec3<Unit>& axis) {
    const Vec3<Unit> once = normalised(without(v, axis));
    if (once == Vec3<Unit>{}) return perpendicular_to(axis);
    // For nearly parallel directions the remainder is small, and rounding errors large in it: a second pass removes
    // them.
    return normalised(without(once, axis));
}

/// The engine's own keep 60 bits until the products are rounded.
SineCosine60 sine_cosine_by(SineMethod method, Angle angle) {
    if (method == SineMethod::NearestStep) return sine_cosine(angle);
    return {convert<Sine60>(sine(angle, method)), convert<Sine60>(cosine(angle, method))};
}

}  // namespace

Basis view_basis(Angle yaw, Angle pitch, Angle roll, SineMethod method) {
    const auto [sy, cy] = sine_cosine_by(method, yaw);
    const auto [sp, cp] = sine_cosine_by(method, pitch);
    const auto [sr, cr] = sine_cosine_by(method, roll);
    const Sine60 sr_sp = multiply(sr, sp), cr_sp = multiply(cr, sp);
    return {
        .right =
            rounded(multiply(cr, sy) - multiply(sr_sp, cy), -multiply(sr_sp, sy) - multiply(cr, cy), -multiply(sr, cp)),
        .up = rounded(multiply(cr_sp, cy) + multiply(sr, sy), multiply(cr_sp, sy) - multiply(sr, cy), multiply(cr, cp)),
        .forward = rounded(multiply(cp, cy), multiply(cp, sy), -sp)};
}

Basis rounded_to(const Basis& basis, std::int32_t fraction_bits) {
    return {rounded_to(basis.right, fraction_bits), rounded_to(basis.up, fraction_bits),
            rounded_to(basis.forward, fraction_bits)};
}

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

Basis look_at(const Vec3<World>& world_eye, const Vec3<World>& world_target, const Vec3<Unit>& up_hint,
              Handedness handedness) {
    constexpr Vec3<Unit> kNone{};
    Basis result;
    result.forward = direction_between(world_eye, world_target);
    if (result.forward == kNone) result.forward = perpendicular_to(up_hint);
    Vec3<Unit> right = normalised(cross(result.forward, up_hint));
    if (right == kNone) right = perpendicular_to(result.forward);
    result.up = normalised(cross(right, result.forward));
    result.right = handedness == Handedness::Right ? right : -right;
    return result;
}

Sine60 orthonormal_flaw(const Basis& basis) {
    const std::array axes{basis.right, basis.up, basis.forward};
    std::int64_t worst = 0;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        worst = std::max(worst, std::abs((dot(axes[i], axes[i]) - kOne60).raw));
        worst = std::max(worst, std::abs(dot(axes[i], axes[(i + 1) % axes.size()]).raw));
    }
    return Sine60::from_raw(worst);
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

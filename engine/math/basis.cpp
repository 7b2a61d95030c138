#include "engine/math/basis.h"

#include "engine/fixed/arithmetic.h"
#include "engine/math/vec.h"

namespace oblong {

namespace {

Vec3<Unit> rounded(Sine60 x, Sine60 y, Sine60 z) {
    return {convert<Unit>(x), convert<Unit>(y), convert<Unit>(z)};
}

/// SineMethod::NearestStep keeps 60 bits until the products are rounded.
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

Basis look_at(const Vec3<World>& world_eye, const Vec3<World>& world_target, const Vec3<Unit>& up_hint,
              Handedness handedness) {
    constexpr Vec3<Unit> kNone{};
    Basis result;
    result.forward = normalised(widening_difference(world_target, world_eye));
    if (result.forward == kNone) result.forward = perpendicular_to(up_hint);
    Vec3<Unit> right = normalised(cross(result.forward, up_hint));
    if (right == kNone) right = perpendicular_to(result.forward);
    result.up = normalised(cross(right, result.forward));
    result.right = handedness == Handedness::Right ? right : -right;
    return result;
}

}  // namespace oblong

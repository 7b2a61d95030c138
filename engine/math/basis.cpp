#include "engine/math/basis.h"

#include "engine/fixed/arithmetic.h"

namespace oblong {

namespace {

Vec3<Unit> rounded(Sine60 x, Sine60 y, Sine60 z) {
    return {convert<Unit>(x), convert<Unit>(y), convert<Unit>(z)};
}

}  // namespace

Basis view_basis(Angle yaw, Angle pitch, Angle roll) {
    const auto [sy, cy] = sine_cosine(yaw);
    const auto [sp, cp] = sine_cosine(pitch);
    const auto [sr, cr] = sine_cosine(roll);
    const Sine60 sr_sp = multiply(sr, sp), cr_sp = multiply(cr, sp);
    return {
        .right =
            rounded(multiply(cr, sy) - multiply(sr_sp, cy), -multiply(sr_sp, sy) - multiply(cr, cy), -multiply(sr, cp)),
        .up = rounded(multiply(cr_sp, cy) + multiply(sr, sy), multiply(cr_sp, sy) - multiply(sr, cy), multiply(cr, cp)),
        .forward = rounded(multiply(cp, cy), multiply(cp, sy), -sp)};
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

}  // namespace oblong

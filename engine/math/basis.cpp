#include "engine/math/basis.h"

#include "engine/fixed/wide.h"

namespace oblong {

namespace {

Sine60 product(Sine60 a, Sine60 b) {
    return Sine60::from_raw(mul_shift(a.raw, b.raw, 60));
}

Vec3<Unit> rounded(Sine60 x, Sine60 y, Sine60 z) {
    return {convert<Unit>(x), convert<Unit>(y), convert<Unit>(z)};
}

}  // namespace

Basis view_basis(Angle yaw, Angle pitch, Angle roll) {
    const auto [sy, cy] = sine_cosine(yaw);
    const auto [sp, cp] = sine_cosine(pitch);
    const auto [sr, cr] = sine_cosine(roll);
    const Sine60 sr_sp = product(sr, sp), cr_sp = product(cr, sp);
    return {
        .right = rounded(product(cr, sy) - product(sr_sp, cy), -product(sr_sp, sy) - product(cr, cy), -product(sr, cp)),
        .up = rounded(product(cr_sp, cy) + product(sr, sy), product(cr_sp, sy) - product(sr, cy), product(cr, cp)),
        .forward = rounded(product(cp, cy), product(cp, sy), -sp)};
}

FineBasis y_up_fine_basis(Angle yaw, Angle pitch, Angle roll) {
    const auto [sy, cy] = sine_cosine(yaw);
    const auto [sp, cp] = sine_cosine(pitch);
    const auto [sr, cr] = sine_cosine(roll);
    const Sine60 sr_sp = product(sr, sp), cr_sp = product(cr, sp);
    return {.right = {product(cr, cy) - product(sr_sp, sy), product(sr, cp), -product(cr, sy) - product(sr_sp, cy)},
            .up = {-product(cr_sp, sy) - product(sr, cy), product(cr, cp), product(sr, sy) - product(cr_sp, cy)},
            .forward = {product(cp, sy), sp, product(cp, cy)}};
}

Basis y_up_basis(Angle yaw, Angle pitch, Angle roll) {
    const FineBasis fine = y_up_fine_basis(yaw, pitch, roll);
    return {.right = convert<Unit>(fine.right), .up = convert<Unit>(fine.up), .forward = convert<Unit>(fine.forward)};
}

}  // namespace oblong

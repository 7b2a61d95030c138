#include "engine/math/rotation.h"

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/trig.h"
#include "engine/math/vec.h"

namespace oblong {

namespace {

using Vec60 = Vec3<Sine60>;

Sine60 scaled(Unit component, Sine60 factor) {
    return Sine60::from_raw(mul_shift(component.raw, factor.raw, 30));
}
Vec60 scaled(const Vec3<Unit>& v, Sine60 factor) {
    return {scaled(v.x, factor), scaled(v.y, factor), scaled(v.z, factor)};
}

Sine60 scaled(Sine60 component, Sine60 factor) {
    return Sine60::from_raw(mul_shift(component.raw, factor.raw, 60));
}
Vec60 scaled(const Vec60& v, Sine60 factor) {
    return {scaled(v.x, factor), scaled(v.y, factor), scaled(v.z, factor)};
}

}  // namespace

Vec3<Unit> rotate_about_axis(const Vec3<Unit>& direction, const Vec3<Unit>& axis, Angle angle) {
    const auto [sine60, cosine60] = sine_cosine(angle);
    const Sine60 along_axis = scaled(dot(axis, direction), Sine60::from_int(1) - cosine60);
    return saturating_convert<Unit>(scaled(direction, cosine60) + scaled(cross(axis, direction), sine60) +
                                    scaled(axis, along_axis));
}

Basis rotate_about_axis(const Basis& basis, const Vec3<Unit>& axis, Angle angle) {
    return {.right = rotate_about_axis(basis.right, axis, angle),
            .up = rotate_about_axis(basis.up, axis, angle),
            .forward = rotate_about_axis(basis.forward, axis, angle)};
}

Vec3<Unit> project_onto_axes(const Vec3<Unit>& direction, const Basis& axes) {
    return saturating_convert<Unit>(
        Vec60{dot(direction, axes.right), dot(direction, axes.up), dot(direction, axes.forward)});
}

Vec3<Unit> sum_along_axes(const Vec3<Unit>& coordinates, const Basis& axes) {
    const auto along = [](const Vec3<Unit>& axis, Unit coordinate) {
        return Vec60{widening_product(axis.x, coordinate), widening_product(axis.y, coordinate),
                     widening_product(axis.z, coordinate)};
    };
    return saturating_convert<Unit>(along(axes.right, coordinates.x) + along(axes.up, coordinates.y) +
                                    along(axes.forward, coordinates.z));
}

}  // namespace oblong

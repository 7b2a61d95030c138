#include "engine/math/quaternion.h"

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/radians.h"
#include "engine/fixed/root.h"
#include "engine/fixed/trig.h"
#include "engine/math/vec.h"

namespace oblong {

namespace {

constexpr Sine60 kOne60 = Sine60::from_int(1);

Sine60 times(Unit a, Sine60 b) {
    return Sine60::from_raw(mul_shift(a.raw, b.raw, 30));
}

Sine60 dot(const Quaternion& a, const Quaternion& b) {
    return widening_product(a.w, b.w) + widening_product(a.x, b.x) + widening_product(a.y, b.y) +
           widening_product(a.z, b.z);
}

/// The weights of two rotations in a blend.
struct Weights {
    Sine60 from, to;
};

/// sin((1 - t) angle) and sin(t angle), where `cosine` is the angle's.
Weights arc_weights(Sine60 cosine, Unit t) {
    const Sine60 sine_squared = kOne60 - multiply(cosine, cosine);
    const Radians angle = radians_of({square_root<Sine60>(sine_squared), cosine});
    const Radians part = times(t, angle);
    return {sine(angle - part), sine(part)};
}

Weights straight_weights(Unit t) {
    const auto part = convert<Sine60>(t);
    return {kOne60 - part, part};
}

Quaternion blend(const Quaternion& from, const Quaternion& to, const Weights& weights) {
    const auto blended = [&weights](Unit a, Unit b) { return (times(a, weights.from) + times(b, weights.to)).raw; };
    const auto unit = normalised_raw(
        std::array{blended(from.w, to.w), blended(from.x, to.x), blended(from.y, to.y), blended(from.z, to.z)});
    return {unit[0], unit[1], unit[2], unit[3]};
}

}  // namespace

Quaternion quaternion_about_axis(const Vec3<Unit>& axis, Angle angle) {
    const auto [sine60, cosine60] = half_angle_sine_cosine(angle);
    return {convert<Unit>(cosine60), convert<Unit>(times(axis.x, sine60)), convert<Unit>(times(axis.y, sine60)),
            convert<Unit>(times(axis.z, sine60))};
}

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    const auto product = [](Unit c, Unit d) { return widening_product(c, d); };
    return {saturating_convert<Unit>(product(a.w, b.w) - product(a.x, b.x) - product(a.y, b.y) - product(a.z, b.z)),
            saturating_convert<Unit>(product(a.w, b.x) + product(a.x, b.w) + product(a.y, b.z) - product(a.z, b.y)),
            saturating_convert<Unit>(product(a.w, b.y) - product(a.x, b.z) + product(a.y, b.w) + product(a.z, b.x)),
            saturating_convert<Unit>(product(a.w, b.z) + product(a.x, b.y) - product(a.y, b.x) + product(a.z, b.w))};
}

Quaternion normalised(const Quaternion& quaternion) {
    const auto unit = normalised_raw(
        std::array<std::int64_t, 4>{quaternion.w.raw, quaternion.x.raw, quaternion.y.raw, quaternion.z.raw});
    return {unit[0], unit[1], unit[2], unit[3]};
}

/// v + 2 w (u x v) + 2 u x (u x v), where u = (x, y, z): rounded once.
Vec3<Unit> rotate(const Vec3<Unit>& direction, const Quaternion& rotation) {
    const Vec3<Unit> u{rotation.x, rotation.y, rotation.z};
    const Vec3<Sine60> once = cross(u, direction);
    const Vec3<Sine60> twice{times(u.y, once.z) - times(u.z, once.y), times(u.z, once.x) - times(u.x, once.z),
                             times(u.x, once.y) - times(u.y, once.x)};
    const auto sum = [&rotation](Unit v, Sine60 first, Sine60 second) {
        const Sine60 half = times(rotation.w, first) + second;
        return saturating_convert<Unit>(convert<Sine60>(v) + half + half);
    };
    return {sum(direction.x, once.x, twice.x), sum(direction.y, once.y, twice.y), sum(direction.z, once.z, twice.z)};
}

Basis rotate(const Basis& basis, const Quaternion& rotation) {
    return {.right = rotate(basis.right, rotation),
            .up = rotate(basis.up, rotation),
            .forward = rotate(basis.forward, rotation)};
}

Quaternion slerp(const Quaternion& from, const Quaternion& to, Unit t) {
    if (t <= Unit{}) return from;
    if (t >= Unit::from_int(1)) return to;
    const Sine60 signed_cosine = dot(from, to);
    const bool is_long_way = signed_cosine < Sine60{};
    const Sine60 cosine = is_long_way ? -signed_cosine : signed_cosine;
    const bool is_nearly_straight = kOne60 - cosine < Sine60::from_raw(std::int64_t{1} << (60 - 16));
    return blend(from, is_long_way ? -to : to, is_nearly_straight ? straight_weights(t) : arc_weights(cosine, t));
}

}  // namespace oblong

#include "engine/math/soft_float.h"
#include "engine/math/vec.h"
#include "engine/math/wide_sum.h"
#include "engine/methods/triangles.h"

namespace oblong {

namespace {

using Corner = Vec3<Fixed<std::int32_t, 14>>;
/// B x C, C x A, A x B, 28 fraction bits: components below 2^59.
using CornerNormals = std::array<Vec3<Fixed<std::int64_t, 28>>, 3>;

/// View rays: (x, y, 1) through the centre of the anchor, and its change per pixel.
struct PixelRay {
    SoftFloat x, y, x_per_column, y_per_row;
    PixelPosition anchor;

    PixelRay(const Projection& projection, PixelPosition pixel) : anchor(pixel) {
        const SoftFloat one = SoftFloat::from(1, 0);
        x_per_column = one / SoftFloat::from(projection.x.multiplier);
        y_per_row = -(one / SoftFloat::from(projection.y.multiplier));
        x = SoftFloat::from(2 * std::int64_t{pixel.column} + 1 - projection.width_px, -1) * x_per_column;
        y = SoftFloat::from(2 * std::int64_t{pixel.row} + 1 - projection.height_px, -1) * y_per_row;
    }
};

/// The sum of the three normals, each times its weight.
template <int Frac>
Vec3<SoftFloat> weighted_sum(const CornerNormals& normals, const std::array<Fixed<std::int64_t, Frac>, 3>& weights) {
    WideSum x, y, z;
    for (std::size_t i = 0; i < 3; ++i) {
        x.add_product(normals[i].x, weights[i]);
        y.add_product(normals[i].y, weights[i]);
        z.add_product(normals[i].z, weights[i]);
    }
    constexpr int kExponent = -(28 + Frac);
    return {x.scaled(kExponent), y.scaled(kExponent), z.scaled(kExponent)};
}

SoftFloat determinant(const Corner& a, const CornerNormals& normals) {
    WideSum sum;
    sum.add_product(a.x, normals[0].x);
    sum.add_product(a.y, normals[0].y);
    sum.add_product(a.z, normals[0].z);
    return sum.scaled(-42);
}

/// Converts to the format. A slope beyond its range changes by more than the whole texture from pixel to pixel, so that
/// its low bits do not matter.
template <class Value>
Value step_of(const SoftFloat& value) {
    constexpr auto kSteepest = Value::from_raw(std::int64_t{1} << 62);
    return fixed_of<Value>(value).value_or(value.mantissa < 0 ? -kSteepest : kSteepest);
}

template <class Value>
LinearQuantity<Value> quantity_of(const Vec3<SoftFloat>& slope, const SoftFloat& whole, const PixelRay& ray) {
    LinearQuantity<Value> quantity;
    quantity.per_column = step_of<Value>(slope.x * ray.x_per_column / whole);
    quantity.per_row = step_of<Value>(slope.y * ray.y_per_row / whole);
    const auto at_anchor = step_of<Value>((slope.x * ray.x + slope.y * ray.y + slope.z) / whole);
    quantity.origin = stepped(stepped(at_anchor, quantity.per_column, -std::int64_t{ray.anchor.column}),
                              quantity.per_row, -std::int64_t{ray.anchor.row});
    return quantity;
}

}  // namespace

std::optional<TextureGradients> make_triangle_gradients(const std::array<TexturedCorner, 3>& corners,
                                                        const Projection& projection, PixelPosition anchor) {
    const auto& [a, b, c] = corners;
    const CornerNormals normals{cross(b.position, c.position), cross(c.position, a.position),
                                cross(a.position, b.position)};
    const SoftFloat whole = determinant(a.position, normals);
    constexpr Multiplier kNone{};
    if (whole.is_zero() || projection.x.multiplier <= kNone || projection.y.multiplier <= kNone) return std::nullopt;

    const PixelRay ray(projection, anchor);
    constexpr auto kOne = Fixed<std::int64_t, 0>::from_int(1);
    return TextureGradients{quantity_of<InverseZ>(weighted_sum(normals, std::array{kOne, kOne, kOne}), whole, ray),
                            quantity_of<TexelOverZ>(weighted_sum(normals, std::array{a.u, b.u, c.u}), whole, ray),
                            quantity_of<TexelOverZ>(weighted_sum(normals, std::array{a.v, b.v, c.v}), whole, ray)};
}

}  // namespace oblong

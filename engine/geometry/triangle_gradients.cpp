#include "engine/geometry/triangle_gradients.h"

#include "engine/math/soft_float.h"
#include "engine/math/vec.h"
#include "engine/math/wide_sum.h"

namespace oblong {

namespace {

using Corner = Vec3<Fixed<std::int32_t, 14>>;
/// B x C, C x A, A x B, 28 fraction bits: components below 2^59.
using CornerNormals = std::array<Vec3<Fixed<std::int64_t, 28>>, 3>;

/// Where pixels look: along (x, y, 1) through the centre of the anchor, and how that changes by pixels.
struct PixelRay {
    SoftFloat x, y, x_per_column, y_per_row;
    PixelPosition anchor;

    PixelRay(const Projection& projection, PixelPosition pixel) : anchor(pixel) {
        const SoftFloat one = SoftFloat::from(1, 0);
        x_per_column = one / SoftFloat::from(projection.x.multiplier.raw, -32);
        y_per_row = -(one / SoftFloat::from(projection.y.multiplier.raw, -32));
        x = SoftFloat::from(2 * std::int64_t{pixel.column} + 1 - projection.width_px, -1) * x_per_column;
        y = SoftFloat::from(2 * std::int64_t{pixel.row} + 1 - projection.height_px, -1) * y_per_row;
    }
};

/// The sum of the three normals, each times its weight; `exponent` scales normals and weights alike.
Vec3<SoftFloat> weighted_sum(const CornerNormals& normals, const std::array<std::int64_t, 3>& weights, int exponent) {
    WideSum x, y, z;
    for (std::size_t i = 0; i < 3; ++i) {
        x.add_product(normals[i].x.raw, weights[i]);
        y.add_product(normals[i].y.raw, weights[i]);
        z.add_product(normals[i].z.raw, weights[i]);
    }
    return {x.scaled(exponent), y.scaled(exponent), z.scaled(exponent)};
}

SoftFloat determinant(const Corner& a, const CornerNormals& normals) {
    WideSum sum;
    sum.add_product(a.x.raw, normals[0].x.raw);
    sum.add_product(a.y.raw, normals[0].y.raw);
    sum.add_product(a.z.raw, normals[0].z.raw);
    return sum.scaled(-42);
}

/// In the given format; what is steeper than it holds changes by more than any texel from one pixel to the next, and
/// its low bits then do not matter.
std::uint64_t step_of(const SoftFloat& value, int fraction_bits) {
    constexpr std::int64_t kSteepest = std::int64_t{1} << 62;
    return static_cast<std::uint64_t>(
        fixed_of(value, fraction_bits).value_or(value.mantissa < 0 ? -kSteepest : kSteepest));
}

LinearQuantity quantity_of(const Vec3<SoftFloat>& slope, const SoftFloat& whole, const PixelRay& ray,
                           int fraction_bits) {
    LinearQuantity quantity;
    quantity.per_column = step_of(slope.x * ray.x_per_column / whole, fraction_bits);
    quantity.per_row = step_of(slope.y * ray.y_per_row / whole, fraction_bits);
    const SoftFloat at_anchor = (slope.x * ray.x + slope.y * ray.y + slope.z) / whole;
    quantity.origin = step_of(at_anchor, fraction_bits) -
                      quantity.per_column * static_cast<std::uint64_t>(std::int64_t{ray.anchor.column}) -
                      quantity.per_row * static_cast<std::uint64_t>(std::int64_t{ray.anchor.row});
    return quantity;
}

}  // namespace

std::optional<TextureGradients> make_triangle_gradients(const std::array<TexturedCorner, 3>& corners,
                                                        const Projection& projection, PixelPosition anchor) {
    const auto& [a, b, c] = corners;
    const CornerNormals normals{cross(b.position, c.position), cross(c.position, a.position),
                                cross(a.position, b.position)};
    const SoftFloat whole = determinant(a.position, normals);
    if (whole.is_zero() || projection.x.multiplier.raw <= 0 || projection.y.multiplier.raw <= 0) return std::nullopt;

    const PixelRay ray(projection, anchor);
    return TextureGradients{quantity_of(weighted_sum(normals, {1, 1, 1}, -28), whole, ray, 44),
                            quantity_of(weighted_sum(normals, {a.u_16, b.u_16, c.u_16}, -44), whole, ray, 30),
                            quantity_of(weighted_sum(normals, {a.v_16, b.v_16, c.v_16}, -44), whole, ray, 30)};
}

}  // namespace oblong

#include "engine/view/texture_gradients.h"

#include <algorithm>

#include "engine/base/range_probe.h"
#include "engine/fixed/arithmetic.h"

namespace oblong {

namespace {

/// The slope of a linear quantity over X and Y (screen position / multiplier), and its value straight ahead.
template <class Value>
struct ViewSlope {
    Value x, y, ahead;
};

template <RangeName Name, int Frac>
auto rotate_to_view(const Vec3<Fixed<std::int32_t, Frac>>& world, const Basis& axes) {
    const auto along = [&](const Vec3<Unit>& axis) {
        const auto sum = dot(world, axis);
        note_range<Name>(sum);
        return sum;
    };
    return ViewSlope<Fixed<std::int64_t, Frac + 30>>{along(axes.right), along(axes.up), along(axes.forward)};
}

template <class Value>
inline LinearQuantity<Value> anchor_at_centre(const ViewSlope<Value>& slope, const InverseProjection& projection) {
    // Half pixels from the optical centre to the centre of pixel (0, 0), which is at half a pixel.
    const auto halves = [](Value step, std::int32_t centre_1) {
        return product<Value>(Fixed<std::int32_t, 1>::from_raw(1 - centre_1), step, Rounding::Floor);
    };
    const Value at_first_column = stepped(slope.ahead, halves(slope.x, projection.centre_x_1), 1);
    return {stepped(at_first_column, halves(slope.y, projection.centre_y_1), 1), slope.x, slope.y};
}

/// 1 / D as a 63-bit number and a scale.
struct DistanceReciprocal {
    std::int64_t mantissa;  ///< 2^(62 + log2) / D, in (2^61, 2^62]
    int log2;

    explicit DistanceReciprocal(PlaneDistance distance) : log2(log2_floor(distance)) {
        mantissa = mul_div(std::int64_t{1} << 62, std::int64_t{1} << log2, distance.raw);
    }
    InverseZ times(Sine60 value) const {
        constexpr int kDropped = Sine60::kFractionBits - PlaneDistance::kFractionBits - InverseZ::kFractionBits;
        const auto slope = InverseZ::from_raw(mul_shift(value.raw, mantissa, 62 + log2 + kDropped));
        note_range<"slope of 1/z">(slope);
        return slope;
    }
};

LinearQuantity<TexelOverZ> texel_quantity(const Vec3<TexelAxis>& world_axis, Texel eye_texel,
                                          const ViewSlope<InverseZ>& inverse_z, const Basis& axes,
                                          const InverseProjection& projection, int mip) {
    const auto with_eye = [&](TexelOverZ part, InverseZ inverse) {
        const TexelOverZ sum = part + product<TexelOverZ>(eye_texel, inverse);
        note_range<"slope of u/z, v/z">(sum);
        return floor_shift(sum, mip);
    };
    const auto axis = rotate_to_view<"texture axis in view axes">(world_axis, axes);
    const ViewSlope<TexelOverZ> slope{with_eye(product<TexelOverZ>(axis.x, projection.inverse_x), inverse_z.x),
                                      with_eye(product<TexelOverZ>(-axis.y, projection.inverse_y), inverse_z.y),
                                      with_eye(convert<TexelOverZ>(axis.ahead), inverse_z.ahead)};
    return anchor_at_centre(slope, projection);
}

/// sec a is the root of the sum of 1 and both tangents' squares, which is at most the largest of the three plus half of
/// the others.
WidthAtOne least_pixel_width(const InverseProjection& inverse, Unit shear_x, Unit shear_y) {
    const auto tangent = [](InverseMultiplier step, std::int32_t halves, Unit shear) {
        return product<WidthAtOne>(step, Fixed<std::int32_t, 1>::from_raw(halves)) +
               convert<WidthAtOne>(absolute(shear));
    };
    const WidthAtOne x = tangent(inverse.inverse_x, inverse.centre_x_1, shear_x);
    const WidthAtOne y = tangent(inverse.inverse_y, inverse.centre_y_1, shear_y), one = WidthAtOne::from_int(1);
    const WidthAtOne secant = floor_shift(x + y + one + std::max({x, y, one}), 1) + WidthAtOne::ulp();
    return product_over<WidthAtOne>(std::min(inverse.inverse_x, inverse.inverse_y), Fixed<std::int32_t, 4>::from_int(1),
                                    secant);
}

/// A plane in a parallel view.
struct ParallelPlane {
    const Vec3<Unit>& normal;
    PlaneDistance eye_distance;
    InverseZ inverse_z;
    const Basis& rays;
};

/// u/z or v/z with constant 1/z. The part of the texture's axis along the rays is replaced by the plane's slope.
LinearQuantity<TexelOverZ> parallel_quantity(const Vec3<TexelAxis>& axis, Texel eye_texel, int mip,
                                             const ParallelPlane& plane, const InverseProjection& projection) {
    using Slope = Fixed<std::int64_t, 32>;  // texels per unit of distance from the plane
    // For planes edge-on or turned round by rounding to the screen: for such slivers any small value will do.
    constexpr auto kLeastFacing = Sine60::from_raw(std::int64_t{1} << 40);
    const Basis& rays = plane.rays;
    const Sine60 facing = std::max(-dot(plane.normal, rays.forward), kLeastFacing);
    const auto per_distance =
        product_over<Slope>(dot(axis, rays.forward), Fixed<std::int64_t, 39>::from_int(1), facing);
    const auto along = [&](const Vec3<Unit>& ray) {
        return convert<TexelOverZ>(dot(axis, ray)) + product<TexelOverZ>(per_distance, dot(plane.normal, ray));
    };
    const Texel ahead = eye_texel + product<Texel>(per_distance, plane.eye_distance);
    const auto of_mip = [&](TexelOverZ value) { return floor_shift(value, mip); };
    const ViewSlope<TexelOverZ> slope{of_mip(product<TexelOverZ>(along(rays.right), projection.inverse_x)),
                                      of_mip(product<TexelOverZ>(-along(rays.up), projection.inverse_y)),
                                      of_mip(product<TexelOverZ>(ahead, plane.inverse_z))};
    return anchor_at_centre(slope, projection);
}

}  // namespace

InverseProjection make_inverse_projection(const Projection& projection, Unit shear_x, Unit shear_y) {
    InverseProjection inverse{reciprocal<InverseMultiplier>(projection.x.multiplier),
                              reciprocal<InverseMultiplier>(projection.y.multiplier),
                              projection.width_px,
                              projection.height_px,
                              {}};
    inverse.least_pixel_width = least_pixel_width(inverse, shear_x, shear_y);
    return inverse;
}

PlaneInverseZ make_inverse_z(const Vec3<Unit>& normal, PlaneDistance eye_distance, const Basis& rays,
                             const InverseProjection& projection) {
    const auto in_view = rotate_to_view<"normal in view axes">(normal, rays);
    const DistanceReciprocal over_distance(eye_distance);
    const ViewSlope<InverseZ> slope{over_distance.times(-product<Sine60>(in_view.x, projection.inverse_x)),
                                    over_distance.times(product<Sine60>(in_view.y, projection.inverse_y)),
                                    over_distance.times(-in_view.ahead)};
    return {anchor_at_centre(slope, projection), slope.ahead};
}

TextureGradients make_texture_gradients(const TextureAxes& axes, const PlaneInverseZ& inverse_z, const Basis& rays,
                                        const InverseProjection& projection) {
    const ViewSlope<InverseZ> slope{inverse_z.per_column, inverse_z.per_row, inverse_z.ahead};
    return {inverse_z, texel_quantity(axes.s, axes.eye_u, slope, rays, projection, axes.mip),
            texel_quantity(axes.t, axes.eye_v, slope, rays, projection, axes.mip)};
}

TextureGradients make_parallel_gradients(const TextureAxes& axes, const Vec3<Unit>& normal, PlaneDistance eye_distance,
                                         InverseZ inverse_z, const Basis& rays, const InverseProjection& projection) {
    const ParallelPlane plane{normal, eye_distance, inverse_z, rays};
    return {{inverse_z, {}, {}},
            parallel_quantity(axes.s, axes.eye_u, axes.mip, plane, projection),
            parallel_quantity(axes.t, axes.eye_v, axes.mip, plane, projection)};
}

}  // namespace oblong

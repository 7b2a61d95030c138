#include "engine/geometry/texture_gradients.h"

#include <bit>

#include "engine/base/range_probe.h"
#include "engine/fixed/wide.h"

namespace oblong {

namespace {

/// The slope of a linear quantity over X and Y (per screen position over multiplier), and its value straight ahead.
struct ViewSlope {
    std::int64_t x, y, ahead;
};

template <int Frac>
ViewSlope rotate_to_view(const Vec3<Fixed<std::int32_t, Frac>>& world, const Basis& axes) {
    const auto along = [&](const Vec3<Unit>& axis) {
        const std::int64_t sum = std::int64_t{world.x.raw} * axis.x.raw + std::int64_t{world.y.raw} * axis.y.raw +
                                 std::int64_t{world.z.raw} * axis.z.raw;
        note_range<(Frac == Unit::kFractionBits ? Quantity::NormalSlope : Quantity::TexelAxisSlope)>(sum);
        return sum;
    };
    return {along(axes.right), along(axes.up), along(axes.forward)};
}

LinearQuantity anchor_at_centre(std::int64_t ahead, std::int64_t per_column, std::int64_t per_row,
                                const InverseProjection& projection) {
    // Half-pixel steps from the optical centre to the centre of pixel (0, 0), whose own centre is one half-pixel in.
    const auto halves = [](std::int64_t step, std::int32_t centre_1) {
        return mul_shift(step, 1 - std::int64_t{centre_1}, 1, Rounding::Floor);
    };
    LinearQuantity quantity;
    quantity.per_column = static_cast<std::uint64_t>(per_column);
    quantity.per_row = static_cast<std::uint64_t>(per_row);
    quantity.origin = static_cast<std::uint64_t>(ahead) +
                      static_cast<std::uint64_t>(halves(per_column, projection.centre_x_1)) +
                      static_cast<std::uint64_t>(halves(per_row, projection.centre_y_1));
    return quantity;
}

/// 1 / D for D with 42 fraction bits: reciprocal in [2^62, 2^63] and the shift that turns (N .60) * reciprocal into
/// .44.
struct DistanceReciprocal {
    std::int64_t mantissa;
    int shift;

    explicit DistanceReciprocal(PlaneDistance distance) {
        const int log2 = 63 - std::countl_zero(static_cast<std::uint64_t>(distance.raw));
        // The mantissa is 2^(62 + log2) / D, in (2^61, 2^62]; N.60 / D.42 = .18, and 44 - 18 = 26.
        mantissa = mul_div(std::int64_t{1} << 62, std::int64_t{1} << log2, distance.raw, Rounding::NearestHalfUp);
        shift = 62 + log2 - 26;
    }
    std::int64_t times_60(std::int64_t value_60) const {
        const std::int64_t slope_44 = mul_shift(value_60, mantissa, shift, Rounding::NearestHalfUp);
        note_range<Quantity::InverseZSlope>(slope_44);
        return slope_44;
    }
};

LinearQuantity texel_quantity(const ViewSlope& axis_53, std::int64_t eye_texel_16, const ViewSlope& inverse_z_44,
                              const InverseProjection& projection, int mip) {
    const auto with_eye = [&](std::int64_t part_30, std::int64_t inverse_44) {
        const std::int64_t sum_30 = part_30 + mul_shift(eye_texel_16, inverse_44, 30, Rounding::NearestHalfUp);
        note_range<Quantity::TexelSlope>(sum_30);
        return floor_shift(sum_30, mip);
    };
    return anchor_at_centre(
        with_eye(rounded_shift(axis_53.ahead, 23, Rounding::NearestHalfUp), inverse_z_44.ahead),
        with_eye(mul_shift(axis_53.x, projection.inverse_x_62, 62 + 23, Rounding::NearestHalfUp), inverse_z_44.x),
        with_eye(mul_shift(-axis_53.y, projection.inverse_y_62, 62 + 23, Rounding::NearestHalfUp), inverse_z_44.y),
        projection);
}

}  // namespace

InverseProjection make_inverse_projection(const Projection& projection) {
    const auto inverse_62 = [](Multiplier multiplier) {
        return mul_div(std::int64_t{1} << 62, std::int64_t{1} << 32, multiplier.raw, Rounding::NearestHalfUp);
    };
    return {inverse_62(projection.x.multiplier), inverse_62(projection.y.multiplier), projection.width_px,
            projection.height_px};
}

TextureGradients make_texture_gradients(const TexturedPlane& plane, const Basis& axes,
                                        const InverseProjection& projection) {
    const ViewSlope normal_60 = rotate_to_view(plane.normal, axes);
    const DistanceReciprocal reciprocal(plane.eye_distance);
    const ViewSlope inverse_z_44{
        reciprocal.times_60(-mul_shift(normal_60.x, projection.inverse_x_62, 62, Rounding::NearestHalfUp)),
        reciprocal.times_60(mul_shift(normal_60.y, projection.inverse_y_62, 62, Rounding::NearestHalfUp)),
        reciprocal.times_60(-normal_60.ahead)};

    TextureGradients gradients;
    gradients.inverse_z_44 = anchor_at_centre(inverse_z_44.ahead, inverse_z_44.x, inverse_z_44.y, projection);
    gradients.u_over_z_30 =
        texel_quantity(rotate_to_view(plane.s, axes), plane.eye_u_16, inverse_z_44, projection, plane.mip);
    gradients.v_over_z_30 =
        texel_quantity(rotate_to_view(plane.t, axes), plane.eye_v_16, inverse_z_44, projection, plane.mip);
    return gradients;
}

}  // namespace oblong

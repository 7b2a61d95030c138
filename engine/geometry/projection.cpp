#include "engine/geometry/projection.h"

#include <algorithm>
#include <cstdlib>

#include "engine/fixed/trig.h"

namespace oblong {

namespace {

/// Larger multipliers, those of fields of view below a thousandth of a degree, stay here.
constexpr Multiplier kLargestMultiplier = Multiplier::from_raw(std::int64_t{1} << 62);

ProjectionAxis make_axis(Multiplier multiplier, std::int32_t size_px) {
    ProjectionAxis axis;
    axis.multiplier = std::min(multiplier, kLargestMultiplier);
    axis.coarse_16 = rounded_shift(axis.multiplier.raw, 16, Rounding::NearestHalfUp);
    axis.fast_limit = (std::int64_t{1} << 61) / (axis.coarse_16 + 1);
    axis.centre = ScreenWide::from_raw(std::int64_t{size_px} * 128);
    return axis;
}

}  // namespace

Projection make_projection(const ScreenMode& mode, Degrees field_of_view, bool correct_aspect) {
    const SineCosine60 half = sine_cosine(Degrees::from_raw(field_of_view.raw / 2));
    const std::int64_t half_width_32 = std::int64_t{mode.width_px} << 31;
    const Multiplier distance =
        Multiplier::from_raw(mul_div(half_width_32, half.cosine.raw, half.sine.raw, Rounding::NearestHalfUp));

    const Ratio squeeze = (mode.display * Ratio{mode.height_px, mode.width_px}).reduced();
    const Multiplier squeezed =
        Multiplier::from_raw(mul_div(distance.raw, squeeze.numerator, squeeze.denominator, Rounding::NearestHalfUp));

    Projection projection;
    projection.x = make_axis(distance, mode.width_px);
    projection.y = make_axis(correct_aspect ? squeezed : distance, mode.height_px);
    projection.width_px = mode.width_px;
    projection.height_px = mode.height_px;
    return projection;
}

bool is_drawable(const Projection& projection) {
    constexpr Multiplier kLeast = Multiplier::from_raw((std::int64_t{1} << 31) + 1);
    return projection.x.multiplier >= kLeast && projection.y.multiplier >= kLeast;
}

std::int64_t project_axis_wide_8(const ProjectionAxis& axis, std::int64_t view_16, std::int64_t z_16) {
    if (std::abs(view_16) <= z_16 * 64) return mul_div(view_16, axis.coarse_16, z_16 * 256, Rounding::NearestHalfUp);
    const std::int64_t exact_8 =
        mul_div(view_16, axis.multiplier.raw, z_16 * (std::int64_t{1} << 24), Rounding::NearestHalfUp);
    // At view = 64 z the other method gives 64 * coarse_16 / 256.
    if (view_16 < 0) return std::min(exact_8, rounded_shift(-axis.coarse_16, 2, Rounding::NearestHalfUp));
    return std::max(exact_8, rounded_shift(axis.coarse_16, 2, Rounding::NearestHalfUp));
}

}  // namespace oblong

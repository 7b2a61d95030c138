#include "engine/view/projection.h"

#include <algorithm>

#include "engine/fixed/trig.h"

namespace oblong {

namespace {

/// The limit of multipliers, reached by fields of view below a thousandth of a degree.
constexpr Multiplier kLargestMultiplier = Multiplier::from_raw(std::int64_t{1} << 62);

using HalfPixels = Fixed<std::int64_t, 1>;

ProjectionAxis make_axis(Multiplier multiplier, std::int32_t size_px) {
    ProjectionAxis axis;
    axis.multiplier = std::min(multiplier, kLargestMultiplier);
    axis.coarse = convert<CoarseMultiplier>(axis.multiplier);
    axis.fast_limit =
        View::from_raw(CoarseMultiplier::from_raw(std::int64_t{1} << 61) / (axis.coarse + CoarseMultiplier::ulp()));
    axis.centre = convert<ScreenWide>(HalfPixels::from_raw(size_px));
    return axis;
}

}  // namespace

View shown_half_width(const ViewWindow& window, const ScreenMode& mode) {
    using Whole = Fixed<std::int64_t, 0>;
    const Ratio display = mode.display.reduced();
    const auto by_height = product_over<View>(window.half_height, Whole::from_int(display.numerator),
                                              Whole::from_int(display.denominator));
    return std::max(window.half_width, by_height);
}

Projection make_projection(const ScreenMode& mode, const ViewWindow& window, bool correct_aspect) {
    const auto half_width = convert<Multiplier>(HalfPixels::from_raw(mode.width_px));
    const auto distance = product_over<Multiplier>(half_width, window.distance, shown_half_width(window, mode));

    using Whole = Fixed<std::int64_t, 0>;
    const Ratio pixel = mode.pixel().reduced();
    const auto squeezed =
        product_over<Multiplier>(distance, Whole::from_int(pixel.numerator), Whole::from_int(pixel.denominator));

    Projection projection;
    projection.x = make_axis(distance, mode.width_px);
    projection.y = make_axis(correct_aspect ? squeezed : distance, mode.height_px);
    projection.width_px = mode.width_px;
    projection.height_px = mode.height_px;
    constexpr auto kEnd = CoarseMultiplier::from_raw(1 << 26);
    projection.short_z_end = std::max(projection.x.coarse, projection.y.coarse) < kEnd ? 1u << 30 : 0;
    return projection;
}

ViewWindow window_of(Degrees field_of_view) {
    const SineCosine60 half = sine_cosine(floor_shift(field_of_view, 1));
    return {View::from_raw(half.sine.raw), View::from_raw(half.cosine.raw)};
}

Projection make_projection(const ScreenMode& mode, Degrees field_of_view, bool correct_aspect) {
    return make_projection(mode, window_of(field_of_view), correct_aspect);
}

bool is_drawable(const Projection& projection) {
    constexpr Multiplier kLeast = Multiplier::from_raw((std::int64_t{1} << 31) + 1);
    return projection.x.multiplier >= kLeast && projection.y.multiplier >= kLeast;
}

ScreenWide project_axis_wide(const ProjectionAxis& axis, View view, View z) {
    if (absolute(view) <= z * 64) return product_over<ScreenWide>(view, axis.coarse, z);
    const auto exact = product_over<ScreenWide>(view, axis.multiplier, z);
    // The result of the fast method at view = 64 z.
    if (view < View{}) return std::min(exact, convert<ScreenWide>(-axis.coarse * 64));
    return std::max(exact, convert<ScreenWide>(axis.coarse * 64));
}

}  // namespace oblong

#include "engine/fixed/radians.h"

#include "engine/fixed/sine_series.h"
#include "engine/fixed/wide.h"

namespace oblong {

namespace {

/// d + d^3 / 6; the next term, 3 d^5 / 40, is below 2^-74 for half a binary degree.
std::int64_t arcsine_of_little_60(std::int64_t d) {
    return d + mul_shift(mul_shift(d, d, 60), d, 60) / 6;
}

std::int64_t radians_of_bam_60(Angle angle) {
    return rounded_shift(detail::radians_of_halves_62(2 * angle.bam), 2, Rounding::NearestHalfUp);
}

}  // namespace

Radians radians_of(const SineCosine60& unit_vector) {
    const Angle nearest = arctangent2(unit_vector.sine.raw, unit_vector.cosine.raw);
    const SineCosine60 near = sine_cosine(nearest);
    const std::int64_t sine_of_rest =
        mul_shift(unit_vector.sine.raw, near.cosine.raw, 60) - mul_shift(unit_vector.cosine.raw, near.sine.raw, 60);
    return Radians::from_raw(radians_of_bam_60(nearest) + arcsine_of_little_60(sine_of_rest));
}

Sine60 sine(Radians angle) {
    const std::int64_t quarter_62 = detail::radians_of_halves_62(detail::kQuarterHalves);
    const std::int64_t radians_62 = angle.raw * 4;
    const std::int64_t sine_62 = radians_62 <= quarter_62 / 2 ? detail::sine_series_62(radians_62)
                                                              : detail::cosine_series_62(quarter_62 - radians_62);
    return convert<Sine60>(Fixed<std::int64_t, 62>::from_raw(sine_62));
}

}  // namespace oblong

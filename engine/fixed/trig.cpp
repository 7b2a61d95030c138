#include "engine/fixed/trig.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/base/table.h"
#include "engine/fixed/sine_series.h"
#include "engine/fixed/wide.h"

namespace oblong {

namespace {

using namespace detail;

constexpr int kFineSteps = 256;
constexpr int kCoarseSteps = kQuarterHalves / kFineSteps;

struct FineEntry {
    std::int64_t sine, cosine;
};

/// Sines of a quarter turn in 128 steps.
constexpr auto kCoarseSines = [] {
    std::array<std::int64_t, kCoarseSteps + 1> table{};
    for (int i = 0; i <= kCoarseSteps; ++i) item(table, i) = quarter_sine_series_62(i * kFineSteps);
    return table;
}();

/// Sines and cosines of the angles within one coarse step.
constexpr auto kFine = [] {
    std::array<FineEntry, kFineSteps> table{};
    for (int i = 0; i < kFineSteps; ++i) {
        const std::int64_t radians = radians_of_halves_62(i);
        item(table, i) = {sine_series_62(radians), cosine_series_62(radians)};
    }
    return table;
}();

/// sin(coarse + fine) = sin(coarse) cos(fine) + cos(coarse) sin(fine), from 0 to a quarter turn.
std::int64_t quarter_sine_62(int halves) {
    const auto coarse = as_size(halves / kFineSteps);
    const FineEntry& fine = item(kFine, halves % kFineSteps);
    return mul_shift(kCoarseSines[coarse], fine.cosine, 62) +
           mul_shift(kCoarseSines[kCoarseSteps - coarse], fine.sine, 62);
}

/// Mirrors the angle into the first quarter. Rounds the magnitude, so that sin(-a) = -sin(a).
std::int64_t rounded_sine(int halves, int fraction_bits) {
    const int in_half_turn = halves & (2 * kQuarterHalves - 1);
    const int in_quarter = std::min(in_half_turn, 2 * kQuarterHalves - in_half_turn);
    const std::int64_t size = rounded_shift(quarter_sine_62(in_quarter), 62 - fraction_bits, Rounding::NearestHalfUp);
    return (halves & (2 * kQuarterHalves)) == 0 ? size : -size;
}

SineCosine60 sine_cosine_of_halves(int halves) {
    return {Sine60::from_raw(rounded_sine(halves, 60)), Sine60::from_raw(rounded_sine(halves + kQuarterHalves, 60))};
}

Sine60 sine60_of_62(std::int64_t sine62) {
    return convert<Sine60>(Fixed<std::int64_t, 62>::from_raw(sine62));
}

/// Whether small / big is at least the tangent of `halves`.
bool is_tangent_at_least(std::uint64_t small, std::uint64_t big, int halves) {
    const auto sine62 = static_cast<std::uint64_t>(quarter_sine_62(halves));
    const auto cosine62 = static_cast<std::uint64_t>(quarter_sine_62(kQuarterHalves - halves));
    return compare_products(small, cosine62, big, sine62) >= 0;
}

/// The binary angle nearest to arctan(small / big), 0 <= small <= big, by bisection of an eighth of a turn: the largest
/// angle that is at most half a binary degree above arctan(small / big).
int octant_arctangent(std::uint64_t small, std::uint64_t big) {
    int at_least = 0, above = kQuarterTurn.bam / 2 + 1;
    while (above - at_least > 1) {
        const int middle = (at_least + above) / 2;
        (is_tangent_at_least(small, big, 2 * middle - 1) ? at_least : above) = middle;
    }
    return at_least;
}

}  // namespace

Unit sine(Angle angle) {
    return Unit::from_raw(static_cast<std::int32_t>(rounded_sine(2 * angle.bam, Unit::kFractionBits)));
}

Unit cosine(Angle angle) {
    return sine(angle + kQuarterTurn);
}

SineCosine60 sine_cosine(Angle angle) {
    return sine_cosine_of_halves(2 * angle.bam);
}

SineCosine60 half_angle_sine_cosine(Angle angle) {
    return sine_cosine_of_halves(angle.bam);
}

SineCosine60 sine_cosine(Degrees angle) {
    const bool is_obtuse = angle > Degrees::from_int(90);
    const Degrees acute = is_obtuse ? Degrees::from_int(180) - angle : angle;
    const bool is_steep = acute > Degrees::from_int(45);
    const Degrees folded = is_steep ? Degrees::from_int(90) - acute : acute;

    const std::int64_t radians = mul_shift(folded.raw, kRadiansPerDegree68, Degrees::kFractionBits + 68 - 62);
    SineCosine60 result{sine60_of_62(sine_series_62(radians)), sine60_of_62(cosine_series_62(radians))};
    if (folded == Degrees::from_int(45)) result.cosine = result.sine;  // equal, so that the tangent is exactly 1
    if (is_steep) std::swap(result.sine, result.cosine);
    if (is_obtuse) result.cosine = -result.cosine;
    return result;
}

Angle degrees_to_angle(Degrees degrees) {
    // 65536 / (360 * 2^48) = 1 / (360 * 2^32)
    return Angle::from_bam(mul_div(degrees.raw, 1, std::int64_t{360} << 32));
}

Angle arctangent2(std::int64_t y, std::int64_t x) {
    const std::uint64_t size_x = detail::magnitude(x), size_y = detail::magnitude(y);
    if (size_x == 0 && size_y == 0) return Angle{};
    Angle result = Angle::from_bam(octant_arctangent(std::min(size_x, size_y), std::max(size_x, size_y)));
    if (size_y > size_x) result = kQuarterTurn - result;
    if (x < 0) result = kHalfTurn - result;
    return y < 0 ? -result : result;
}

}  // namespace oblong

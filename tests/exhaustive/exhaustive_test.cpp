#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/reciprocal.h"
#include "engine/fixed/root.h"
#include "engine/fixed/sine_methods.h"
#include "engine/fixed/trig.h"
#include "engine/math/basis.h"
#include "engine/math/vec.h"
#include "engine/methods/transforms.h"
#include "tests/math/vectors.h"

namespace oblong::test {
namespace {

/// The smallest of the inputs first, ..., end - 1 for which `holds` is false, if there is one.
template <class Predicate>
std::optional<std::uint64_t> first_failure(std::uint64_t first, std::uint64_t end, Predicate holds) {
    for (std::uint64_t input = first; input < end; ++input)
        if (!holds(input)) return input;
    return std::nullopt;
}

/// The smallest of the inputs first, ..., end - 1 whose value is greater than that of the input before, or is not near:
/// is_near(input, value). No value is asked for before that of `first`.
template <class Value, class IsNear>
std::optional<std::uint64_t> first_rise_or_far(std::uint64_t first, std::uint64_t end, Value value_of, IsNear is_near) {
    auto before = value_of(first);
    return first_failure(first, end, [&](std::uint64_t input) {
        const auto value = value_of(input);
        const bool falls = value <= before;
        before = value;
        return falls && is_near(input, value);
    });
}

/// Expects `holds` of all the inputs first, ..., end - 1.
template <class Predicate>
void expect_all(std::uint64_t first, std::uint64_t end, Predicate holds) {
    EXPECT_EQ(first_failure(first, end, holds), std::nullopt);
}

constexpr std::uint64_t kAll32 = std::uint64_t{1} << 32;

// Numbers of 16 bits have 2^32 pairs: every one of them. Numbers of 32 bits: every one of them.

using Short = Fixed<std::int16_t, 8>;

Short first_of(std::uint64_t pair) {
    return Short::from_raw(static_cast<std::int16_t>(pair & 0xffff));
}

Short second_of(std::uint64_t pair) {
    return Short::from_raw(static_cast<std::int16_t>(pair >> 16));
}

/// q is the floor of n / 256 when 256 q <= n < 256 q + 256; nearest with ties up is the floor of (n + 128) / 256.
bool is_floor_of_256th(std::int32_t quotient, std::int32_t n) {
    return 256 * quotient <= n && n < 256 * quotient + 256;
}

/// The product before it is rounded, in 1/65536, where its quotient by 256 surely fits.
bool is_product(std::uint64_t pair, Rounding rounding, std::int32_t half) {
    const Short a = first_of(pair), b = second_of(pair);
    const std::int32_t exact = std::int32_t{a.raw} * b.raw + half;
    const std::int32_t product = multiply(a, b, rounding).raw;
    if (exact >= 32767 * 256) return product == 32767;
    if (exact < -32768 * 256) return product == -32768;
    return is_floor_of_256th(product, exact);
}

TEST(HardCaseA3, NearestProductOfEveryPairOf16BitNumbers) {
    expect_all(0, kAll32, [](auto pair) { return is_product(pair, Rounding::NearestHalfUp, 128); });
}

TEST(HardCaseA3, FlooredProductOfEveryPairOf16BitNumbers) {
    expect_all(0, kAll32, [](auto pair) { return is_product(pair, Rounding::Floor, 0); });
}

/// Every divisor against every 61st dividend: q is right when |2 (256 a - q b)| <= |b|, or saturated with a's and b's
/// sign.
TEST(HardCaseA1, QuotientOfADenseSetOf16BitPairs) {
    expect_all(0, kAll32 / 61, [](std::uint64_t index) {
        const Short a = first_of(index * 61), b = second_of(index * 61);
        const std::int32_t q = divide<Short>(a, b).raw;
        const std::int32_t n = a.raw * 256;
        if (b.raw == 0) return q == (n == 0 ? 0 : n > 0 ? 32767 : -32768);
        const std::int32_t away = std::abs(n) / std::abs(b.raw);
        if (away > 32768) return q == ((n < 0) == (b.raw < 0) ? 32767 : -32768);
        const bool is_near = 2 * std::abs(n - q * b.raw) <= std::abs(b.raw);
        return is_near || (q == 32767 && n / b.raw >= 32767) || (q == -32768 && n / b.raw <= -32768);
    });
}

TEST(Conversion, EveryWorldCoordinateToScreenIsTheNearest) {
    expect_all(0, kAll32, [](std::uint64_t input) {
        const auto world = World::from_raw(static_cast<std::int32_t>(input));
        const std::int64_t off = std::int64_t{convert<View>(world).raw} - 16 * std::int64_t{world.raw};
        const std::int64_t rest = 16 * std::int64_t{saturating_convert<Screen>(world).raw} - world.raw;
        return off == 0 && -8 < rest && rest <= 8;
    });
}

TEST(Conversion, EveryScreenCoordinateToWorldSaturates) {
    expect_all(0, kAll32, [](std::uint64_t input) {
        const auto screen = Screen::from_raw(static_cast<std::int32_t>(input));
        const std::int64_t exact = 16 * std::int64_t{screen.raw};
        const std::int64_t lowest = World::lowest().raw, highest = World::highest().raw;
        return saturating_convert<World>(screen).raw == std::clamp(exact, lowest, highest);
    });
}

TEST(Conversion, EveryUnitTo16BitsIsFlooredOrNearest) {
    using Unit16 = Fixed<std::int16_t, 14>;
    expect_all(0, kAll32, [](std::uint64_t input) {
        const auto unit = Unit::from_raw(static_cast<std::int32_t>(input));
        const std::int64_t floored = saturating_convert<Unit16>(unit, Rounding::Floor).raw * 65536LL;
        const std::int64_t nearest = saturating_convert<Unit16>(unit).raw * 65536LL;
        const bool saturates = nearest == 32767 * 65536LL && unit.raw > nearest;
        return floored <= unit.raw && unit.raw < floored + 65536 &&
               (saturates || std::abs(2 * (nearest - unit.raw)) <= 65536);
    });
}

// Every mantissa of 32 bits, 2^31 of them. The reference is the definition, r m = 2^62: no division is needed to
// check it, and none is done.

constexpr std::uint64_t kFirst = kAll32 / 2;

/// r m - 2^62.
std::int64_t error_62(std::uint32_t mantissa, std::uint32_t r) {
    return static_cast<std::int64_t>(std::uint64_t{mantissa} * r - (std::uint64_t{1} << 62));
}

/// The first mantissa whose reciprocal is off by more than `limit_62(mantissa)` in 2^-62, or above that of the mantissa
/// before.
template <class Limit>
std::optional<std::uint64_t> first_off_or_rising(ReciprocalMethod method, Limit limit_62) {
    return first_rise_or_far(
        kFirst, kAll32,
        [=](std::uint64_t input) { return mantissa_reciprocal(static_cast<std::uint32_t>(input), method); },
        [=](std::uint64_t input, std::uint32_t r) {
            const auto mantissa = static_cast<std::uint32_t>(input);
            return std::abs(error_62(mantissa, r)) <= limit_62(mantissa);
        });
}

/// What is right within 2^-bits of itself.
auto relative_limit(int bits) {
    return [=](std::uint32_t) { return std::int64_t{1} << (62 - bits); };
}

TEST(HardCaseA4, ExactReciprocalOfEveryMantissaIsTheNearest) {
    expect_all(kFirst, kAll32, [](std::uint64_t input) {
        const auto mantissa = static_cast<std::uint32_t>(input);
        const std::uint32_t r = mantissa_reciprocal(mantissa, ReciprocalMethod::Exact);
        return 2 * std::abs(error_62(mantissa, r)) <= mantissa;
    });
}

TEST(HardCaseA4, TwoStepsOfNewtonsAreWithinOneStepAndFallAtEveryMantissa) {
    const auto a_step = [](std::uint32_t mantissa) { return std::int64_t{mantissa}; };
    EXPECT_EQ(first_off_or_rising(ReciprocalMethod::Table256TwoNewton, a_step), std::nullopt);
}

TEST(HardCaseA5, Table256IsNearAndFallsAtEveryMantissa) {
    EXPECT_EQ(first_off_or_rising(ReciprocalMethod::Table256, relative_limit(9)), std::nullopt);
}

TEST(HardCaseA5, OneStepOfNewtonsFrom1024IsNearAndFallsAtEveryMantissa) {
    EXPECT_EQ(first_off_or_rising(ReciprocalMethod::Table1024Newton, relative_limit(21)), std::nullopt);
}

TEST(HardCaseA6, RootOfEvery32BitNumberIsItsFloor) {
    expect_all(0, kAll32, [](std::uint64_t value) {
        const std::uint64_t r = integer_root(value);
        return r * r <= value && value < (r + 1) * (r + 1);
    });
}

/// Where the floor changes, at r^2: for the 2^28 largest roots of 32 bits.
TEST(HardCaseA6, RootChangesAtEverySquareOf64Bits) {
    expect_all(1, kAll32 / 16, [](std::uint64_t input) {
        const std::uint64_t r = kAll32 - input;
        return integer_root(r * r) == r && integer_root(r * r - 1) == r - 1;
    });
}

constexpr long double kBam = std::numbers::pi_v<long double> / 32768;

/// tan of the limit between two neighbouring binary angles, times 2^62; the 80-bit tangent is right within 2^-62 of it,
/// so that 64 to either side are surely on its sides.
std::int64_t tangent_limit_62(int bam) {
    return static_cast<std::int64_t>(std::ldexp(std::tan((bam - 0.5L) * kBam), 62));
}

/// arctangent2's halving compares y / x with limits that grow, so that it rises with y / x; where it changes, it
/// changes at the limit. That is all inputs of the first eighth of a turn.
TEST(Arctangent, ChangesExactlyAtEveryLimitOfTheFirstEighth) {
    constexpr std::int64_t kOne62 = std::int64_t{1} << 62;
    expect_all(1, 8193, [](std::uint64_t input) {
        const auto bam = static_cast<int>(input);
        const std::int64_t limit = tangent_limit_62(bam);
        return arctangent2(limit + 64, kOne62).bam == bam && arctangent2(limit - 64, kOne62).bam == bam - 1;
    });
}

/// Every ratio of 2^24 to 1: never falls, and is right at the ends.
TEST(Arctangent, RisesOverTheWholeQuarter) {
    constexpr std::int64_t kSteps = std::int64_t{1} << 22;
    const auto at = [](std::uint64_t y) { return arctangent2(static_cast<std::int64_t>(y), kSteps).bam; };
    expect_all(1, 2 * kSteps, [&](std::uint64_t y) { return at(y - 1) <= at(y); });
}

TEST(Sine, EveryMethodAtEveryAngleStaysWithinItsStatedError) {
    // With powers of two that the worst errors stay below.
    constexpr std::pair<SineMethod, double> kMethods[] = {
        {SineMethod::Nearest256, 6.3},       {SineMethod::Lerp256, 13.6},  {SineMethod::Cordic16, 15},
        {SineMethod::Quarter1024Lerp, 21.6}, {SineMethod::Cordic30, 26.0}, {SineMethod::NearestStep, 30.999}};
    for (const auto& [method, error_bits] : kMethods) {
        long double worst = 0;
        for (int bam = 0; bam < 65536; ++bam) {
            const Unit got = sine(Angle::from_bam(bam), method);
            worst =
                std::max(worst, std::abs(std::ldexp(static_cast<long double>(got.raw), -30) - std::sin(bam * kBam)));
        }
        EXPECT_LE(static_cast<double>(std::log2(worst)), -error_bits) << "method " << static_cast<int>(method);
    }
}

/// The worst flaw of a basis that turns `count` times by one degree about an axis.
std::int64_t worst_flaw_of_turns(const Vec3<Unit>& axis, int count) {
    const Angle degree = degrees_to_angle(Degrees::from_int(1));
    Basis basis = view_basis({}, {}, {});
    std::int64_t worst = 0;
    for (int i = 0; i < count; ++i) {
        basis = orthonormalised(rotate_about_axis(basis, axis, degree));
        worst = std::max(worst, worst_flaw_60(basis));
    }
    return worst;
}

TEST(HardCaseT2, TenMillionRotationsStayOrthonormal) {
    constexpr int kTurns = 10'000'000;
    EXPECT_LE(worst_flaw_of_turns({{}, {}, Unit::from_int(1)}, kTurns), kOrthonormal60);
    const Vec3<Unit> oblique = normalised(Vec3<Unit>{Unit::from_raw(3), Unit::from_raw(-5), Unit::from_raw(7)});
    EXPECT_LE(worst_flaw_of_turns(oblique, kTurns), kOrthonormal60);
}

}  // namespace
}  // namespace oblong::test

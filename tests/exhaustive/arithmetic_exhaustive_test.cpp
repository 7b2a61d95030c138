#include <gtest/gtest.h>

#include <algorithm>

#include "engine/fixed/arithmetic.h"
#include "tests/exhaustive/first_failure.h"

// Numbers of 16 bits have 2^32 pairs: every one of them. Numbers of 32 bits: every one of them.

namespace oblong {
namespace {

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

}  // namespace
}  // namespace oblong

#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "engine/fixed/native/native.h"

namespace oblong {

/// How a value between two steps of a format is rounded.
enum class Rounding {
    Floor,         ///< toward minus infinity, as by an arithmetic shift
    NearestHalfUp  ///< to nearest, ties toward plus infinity
};

/// `value >> bits`, rounded toward minus infinity, `bits` 0 to 63. The only place in engine/ that shifts negative
/// numbers.
template <class Int>
constexpr Int floor_shift(Int value, int bits) {
    return static_cast<Int>(value >> bits);  // C++20: two's complement, arithmetic
}

/// value / 2^bits, rounded. `bits` 0 to 62; for NearestHalfUp, value plus half a step must not overflow.
template <class Int>
constexpr Int rounded_shift(Int value, int bits, Rounding rounding) {
    if (bits == 0) return value;
    if (rounding == Rounding::NearestHalfUp) value = static_cast<Int>(value + (Int{1} << (bits - 1)));
    return floor_shift(value, bits);
}

/// A fixed-point number with `Frac` fraction bits: value = raw / 2^Frac. There are no implicit conversions. Sums keep
/// the format (the formats leave head-room: engine/fixed/README.md), products widen.
template <class Int, int Frac>
struct Fixed {
    static_assert(std::is_integral_v<Int> && std::is_signed_v<Int>, "a signed integer holds the value");
    static_assert(Frac >= 0 && Frac < static_cast<int>(sizeof(Int)) * 8, "the fraction fits the integer");

    using Raw = Int;
    static constexpr int kFractionBits = Frac;

    Int raw = 0;

    static constexpr Fixed from_raw(Int value) { return Fixed{value}; }
    static constexpr Fixed from_int(Int value) { return Fixed{static_cast<Int>(value * (Int{1} << Frac))}; }
    static constexpr Fixed lowest() { return Fixed{std::numeric_limits<Int>::min()}; }
    static constexpr Fixed highest() { return Fixed{std::numeric_limits<Int>::max()}; }
    /// One step of the format.
    static constexpr Fixed ulp() { return Fixed{1}; }

    constexpr Fixed operator-() const { return Fixed{static_cast<Int>(-raw)}; }
    constexpr Fixed operator+(Fixed other) const { return Fixed{static_cast<Int>(raw + other.raw)}; }
    constexpr Fixed operator-(Fixed other) const { return Fixed{static_cast<Int>(raw - other.raw)}; }
    constexpr Fixed operator*(Int times) const { return Fixed{static_cast<Int>(raw * times)}; }
    /// Rounded toward zero.
    constexpr Fixed operator/(Int by) const { return Fixed{static_cast<Int>(raw / by)}; }
    /// The quotient as an integer, rounded toward zero.
    constexpr Int operator/(Fixed other) const { return static_cast<Int>(raw / other.raw); }
    constexpr Fixed& operator+=(Fixed other) { return *this = *this + other; }
    constexpr Fixed& operator-=(Fixed other) { return *this = *this - other; }
    constexpr bool operator==(const Fixed&) const = default;
    // Not by a defaulted <=>, for which GCC first tests on i386 whether 64-bit numbers are equal.
    constexpr bool operator<(Fixed other) const { return raw < other.raw; }
    constexpr bool operator>(Fixed other) const { return raw > other.raw; }
    constexpr bool operator<=(Fixed other) const { return raw <= other.raw; }
    constexpr bool operator>=(Fixed other) const { return raw >= other.raw; }
    /// `raw` as unsigned, for hashes and for shifts that may lose high bits.
    constexpr auto bits() const { return static_cast<std::make_unsigned_t<Int>>(raw); }
};

/// `value` in another format, rounded if fraction bits are lost. The result must fit (saturating_convert clamps).
template <class To, class Int, int Frac>
constexpr To convert(Fixed<Int, Frac> value, Rounding rounding = Rounding::NearestHalfUp) {
    using Wide = std::conditional_t<(sizeof(Int) > sizeof(typename To::Raw)), Int, typename To::Raw>;
    const auto wide = static_cast<Wide>(value.raw);
    if constexpr (To::kFractionBits >= Frac)
        return To::from_raw(static_cast<typename To::Raw>(wide * (Wide{1} << (To::kFractionBits - Frac))));
    else
        return To::from_raw(static_cast<typename To::Raw>(rounded_shift(wide, Frac - To::kFractionBits, rounding)));
}

/// `value` rounded to nearest with at most `fraction_bits` (up to Frac) fraction bits, in the same type.
template <class Int, int Frac>
constexpr Fixed<Int, Frac> rounded_to(Fixed<Int, Frac> value, int fraction_bits) {
    const int dropped = Frac - fraction_bits;
    return Fixed<Int, Frac>::from_raw(
        static_cast<Int>(rounded_shift(value.raw, dropped, Rounding::NearestHalfUp) * (Int{1} << dropped)));
}

/// |value|; not of the format's lowest number.
template <class Int, int Frac>
constexpr Fixed<Int, Frac> absolute(Fixed<Int, Frac> value) {
    return value < Fixed<Int, Frac>{} ? -value : value;
}

/// |value| < most; most > 0.
template <class Int, int Frac>
constexpr bool is_within(Fixed<Int, Frac> value, Fixed<Int, Frac> most) {
    return value < most && value > -most;
}

/// floor(value).
template <class Int, int Frac>
constexpr Int floor_of(Fixed<Int, Frac> value) {
    return floor_shift(value.raw, Frac);
}

/// floor(value * 2^Bits); it must fit Int.
template <int Bits, class Int, int Frac>
constexpr Int floor_of(Fixed<Int, Frac> value) {
    if constexpr (Bits >= Frac) return static_cast<Int>(value.raw * (Int{1} << (Bits - Frac)));
    return floor_shift(value.raw, Frac > Bits ? Frac - Bits : 0);
}

/// value / 2^bits, rounded toward minus infinity.
template <class Int, int Frac>
constexpr Fixed<Int, Frac> floor_shift(Fixed<Int, Frac> value, int bits) {
    return Fixed<Int, Frac>::from_raw(floor_shift(value.raw, bits));
}

/// value + step * count modulo 2^64: intermediate sums may overflow if the final one fits.
template <int Frac, class Count>
[[gnu::always_inline]] constexpr Fixed<std::int64_t, Frac> stepped(Fixed<std::int64_t, Frac> value,
                                                                   Fixed<std::int64_t, Frac> step, Count count) {
    std::uint64_t sum = 0;
    if constexpr (std::is_same_v<Count, std::uint32_t>)
        sum = native::wrapping_sum(value.bits(), step.bits(), count);
    else
        sum = value.bits() + step.bits() * static_cast<std::uint64_t>(std::int64_t{count});
    return Fixed<std::int64_t, Frac>::from_raw(static_cast<std::int64_t>(sum));
}

/// a - b in 64 bits; never overflows.
template <class Int, int Frac>
constexpr Fixed<std::int64_t, Frac> widening_difference(Fixed<Int, Frac> a, Fixed<Int, Frac> b) {
    static_assert(sizeof(Int) <= 4, "the difference must fit 64 bits");
    return Fixed<std::int64_t, Frac>::from_raw(std::int64_t{a.raw} - b.raw);
}

/// The exact product, in 64 bits; fraction bits add up.
template <class A, int FracA, class B, int FracB>
constexpr auto widening_product(Fixed<A, FracA> a, Fixed<B, FracB> b) {
    static_assert(sizeof(A) <= 4 && sizeof(B) <= 4, "the product must fit 64 bits");
    return Fixed<std::int64_t, FracA + FracB>::from_raw(std::int64_t{a.raw} * b.raw);
}

/// The same for wider factors, whose product is known to fit 64 bits (tests/ranges).
template <class A, int FracA, class B, int FracB>
constexpr auto bounded_product(Fixed<A, FracA> a, Fixed<B, FracB> b) {
    return Fixed<std::int64_t, FracA + FracB>::from_raw(std::int64_t{a.raw} * b.raw);
}

// The engine's formats; engine/fixed/README.md lists the range that each must hold.
using World = Fixed<std::int32_t, 12>;          ///< world coordinates: 20.12, +-524,288 units by 1/4,096
using Unit = Fixed<std::int32_t, 30>;           ///< components of unit vectors and rotations: 2.30, [-2, 2)
using Sine60 = Fixed<std::int64_t, 60>;         ///< Unit times Unit; sines before their products are rounded: 4.60
using View = Fixed<std::int64_t, 16>;           ///< view positions: 48.16
using PlaneDistance = Fixed<std::int64_t, 42>;  ///< World times Unit: 22.42
using TexelAxis = Fixed<std::int32_t, 23>;      ///< components of texture axes, texels per world unit: 9.23
using Multiplier = Fixed<std::int64_t, 32>;     ///< projection multipliers, pixels: 32.32
using Screen = Fixed<std::int32_t, 8>;          ///< screen positions after clipping, pixels: 24.8
using ScreenWide = Fixed<std::int64_t, 8>;      ///< screen positions before clipping, pixels: 56.8
using WorldWide = Fixed<std::int64_t, 12>;      ///< differences of world coordinates: 52.12
using Texel = Fixed<std::int64_t, 16>;          ///< texture coordinates, texels: 48.16
using InverseZ = Fixed<std::int64_t, 44>;       ///< 1/z, z in world units: 20.44
using TexelOverZ = Fixed<std::int64_t, 30>;     ///< u/z, v/z: 34.30

}  // namespace oblong

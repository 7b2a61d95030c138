#include "engine/level/bsp_floats.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>

#include "engine/fixed/wide.h"

namespace oblong {

namespace {

constexpr std::int32_t kBoxLimit = 1 << 20;
constexpr int kLargestExponent = 14;  ///< with a mantissa of 24 bits below 2^38, so that six decimals fit
constexpr int kDoubleBits = 53;       ///< of a mantissa
constexpr int kFloatBits = 24;        ///< likewise
constexpr int kLeastExponent = -149;  ///< floats are multiples of 2^-149
constexpr int kSumBits = 61;          ///< of a sum's greater term: 8 bits more than are kept, and room for a carry
constexpr int kCellShift = 4;         ///< a lightmap's cell is 16 texels

/// mantissa * 2^exponent.
struct Number {
    std::int64_t mantissa = 0;
    int exponent = 0;
};
/// The same for a float.
struct FloatNumber {
    std::int32_t mantissa = 0;
    int exponent = 0;
    operator Number() const { return {mantissa, exponent}; }
};

int exponent_field(FloatBits value) {
    return static_cast<int>(value.bits >> 23 & 0xff);
}

bool is_finite(FloatBits value) {
    return exponent_field(value) != 0xff;
}

/// `value` is finite.
FloatNumber to_number(FloatBits value) {
    const int field = exponent_field(value);
    const auto fraction = static_cast<std::int32_t>(value.bits & 0x7fffff);
    const std::int32_t magnitude = field == 0 ? fraction : fraction | 0x800000;
    return {value.bits >> 31 ? -magnitude : magnitude, std::max(field, 1) - 150};
}

int bit_width(std::int64_t value) {
    return static_cast<int>(std::bit_width(detail::magnitude(value)));
}

/// value * 2^bits, which must fit.
std::int64_t shift_left(std::int64_t value, int bits) {
    return value * (std::int64_t{1} << bits);
}

/// It must fit.
std::int64_t floor_of(Number value) {
    if (value.exponent < 0) return floor_shift(value.mantissa, std::min(-value.exponent, 63));
    return shift_left(value.mantissa, value.exponent);
}

std::int64_t ceil_of(Number value) {
    return -floor_of({-value.mantissa, value.exponent});
}

/// The nearest integer, ties up; it must fit. The mantissa has at most 60 bits.
std::int64_t nearest_to(Number value) {
    if (value.exponent < 0)
        return rounded_shift(value.mantissa, std::min(-value.exponent, 62), Rounding::NearestHalfUp);
    return shift_left(value.mantissa, value.exponent);
}

/// |value|; none for NaN and beyond 2^38, which exceeds all limits.
std::optional<Number> magnitude_of(FloatBits value) {
    if (!is_finite(value)) return std::nullopt;
    const Number number = to_number(value);
    if (number.exponent > kLargestExponent) return std::nullopt;
    return Number{std::abs(number.mantissa), number.exponent};
}

bool is_in_box(FloatBits value) {
    const auto magnitude = magnitude_of(value);
    return magnitude && ceil_of(*magnitude) <= kBoxLimit;
}

bool is_zero(FloatBits value) {
    return value.bits << 1 == 0;
}

Number product(FloatBits a, FloatBits b) {
    const FloatNumber x = to_number(a), y = to_number(b);
    return {std::int64_t{x.mantissa} * y.mantissa, x.exponent + y.exponent};
}

/// Drops the last `excess` bits: rounds to nearest, ties to even.
Number without_bits(Number value, int excess) {
    if (excess <= 0) return value;
    if (excess > 62) return {};
    const std::int64_t floor = floor_shift(value.mantissa, excess);
    const std::int64_t rest = value.mantissa - shift_left(floor, excess), half = std::int64_t{1} << (excess - 1);
    const bool goes_up = rest > half || (rest == half && floor % 2 != 0);
    return {floor + (goes_up ? 1 : 0), value.exponent + excess};
}

Number rounded_to_double(Number value) {
    return without_bits(value, bit_width(value.mantissa) - kDoubleBits);
}

FloatNumber rounded_to_float(Number value) {
    value = without_bits(value, std::max(bit_width(value.mantissa) - kFloatBits, kLeastExponent - value.exponent));
    return {static_cast<std::int32_t>(value.mantissa), value.exponent};
}

/// value / 2^bits rounded to odd: odd if bits are lost, so that a later rounding to fewer bits gives the same as for
/// the exact value.
std::int64_t shift_right_to_odd(std::int64_t value, int bits) {
    if (bits > 62) return value < 0 ? -1 : 1;
    const std::int64_t floor = floor_shift(value, bits);
    return shift_left(floor, bits) == value ? floor : floor | 1;
}

/// The sum of two doubles that are not 0, rounded as in IEEE 754. In integers, as some processors add with more bits
/// and round twice.
Number sum_of_two(Number a, Number b) {
    if (a.exponent + bit_width(a.mantissa) < b.exponent + bit_width(b.mantissa)) std::swap(a, b);
    const int room = kSumBits - bit_width(a.mantissa);
    a = {shift_left(a.mantissa, room), a.exponent - room};
    const int shift = a.exponent - b.exponent;
    const std::int64_t aligned = shift > 0 ? shift_right_to_odd(b.mantissa, shift) : shift_left(b.mantissa, -shift);
    return rounded_to_double({a.mantissa + aligned, a.exponent});
}

void add(const Number& term, Number& sum) {
    sum = sum.mantissa == 0 ? term : sum_of_two(sum, term);
}

/// A coordinate in cells of 16 texels, rounded down and up.
struct CellRange {
    std::int32_t floor, ceil;
};

CellRange cell_coordinate(const FloatBits3& p, const std::array<FloatBits, 4>& axis) {
    Number texel;
    for (std::size_t i = 0; i < 3; ++i)
        if (!is_zero(p[i]) && !is_zero(axis[i])) add(product(p[i], axis[i]), texel);
    if (!is_zero(axis[3])) add(to_number(axis[3]), texel);
    const auto [mantissa, exponent] = rounded_to_float(texel);
    const int shift = std::min(kCellShift - exponent, 31);
    if (shift <= 0) return {mantissa << -shift, mantissa << -shift};
    const std::int32_t floor = floor_shift(mantissa, shift);
    return {floor, floor + (floor << shift == mantissa ? 0 : 1)};
}

}  // namespace

std::optional<std::int64_t> to_fixed(FloatBits value, int fraction_bits, std::int32_t limit) {
    const auto magnitude = magnitude_of(value);
    if (!magnitude || floor_of(*magnitude) >= limit) return std::nullopt;
    const Number number = to_number(value);
    return nearest_to({number.mantissa, number.exponent + fraction_bits});
}

std::int32_t rest_of_fixed(FloatBits value, int fraction_bits) {
    const Number number = to_number(value);
    const int lost_bits = -(number.exponent + fraction_bits);
    if (lost_bits <= 0) return 0;
    const std::int64_t fixed = nearest_to({number.mantissa, -lost_bits});
    const std::int64_t rest = fixed == 0 ? number.mantissa : number.mantissa - shift_left(fixed, lost_bits);
    return static_cast<std::int32_t>(nearest_to({rest, 30 - lost_bits}));
}

std::optional<std::int32_t> floor_to_int(FloatBits value) {
    if (!is_in_box(value)) return std::nullopt;
    return static_cast<std::int32_t>(floor_of(to_number(value)));
}

std::optional<std::int32_t> ceil_to_int(FloatBits value) {
    if (!is_in_box(value)) return std::nullopt;
    return static_cast<std::int32_t>(ceil_of(to_number(value)));
}

std::string describe(FloatBits value) {
    const bool is_negative = value.bits >> 31 != 0;
    if (!is_finite(value)) return (value.bits & 0x7fffff) != 0 ? "nan" : is_negative ? "-inf" : "inf";
    const auto magnitude = magnitude_of(value);
    const std::string sign = is_negative ? "-" : "";
    if (!magnitude) return sign + "2^" + std::to_string(to_number(value).exponent + 23) + " or more";
    const std::int64_t millionths = nearest_to({magnitude->mantissa * 1000000, magnitude->exponent});
    const std::string decimals = std::to_string(1000000 + millionths % 1000000);
    return sign + std::to_string(millionths / 1000000) + "." + decimals.substr(1);
}

TexelRange texel_range(std::span<const FloatBits3> polygon, const std::array<FloatBits, 4>& axis) {
    CellRange range{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::lowest()};
    for (const FloatBits3& p : polygon) {
        const CellRange cell = cell_coordinate(p, axis);
        range = {std::min(range.floor, cell.floor), std::max(range.ceil, cell.ceil)};
    }
    return {range.floor * 16, (range.ceil - range.floor) * 16};
}

}  // namespace oblong

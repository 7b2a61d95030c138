#include "tools/probe/fields.h"

#include <algorithm>
#include <charconv>

#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/fixed/wide.h"

namespace oblong {

namespace {

constexpr std::int64_t kLargestLength = 32767;
constexpr std::int64_t kLargestSize_px = 32768, kLargestShape = 1 << 20;

/// from_chars accepts no plus sign.
std::string_view without_plus(std::string_view text) {
    return text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text;
}

/// The largest exponent: beyond it, any number is 0 or too large.
constexpr int kLargestExponent = 99;
/// Digits of a fraction that count; 10^18 fits 64 bits.
constexpr std::size_t kFractionDigits = 18;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::string take_digits(std::string_view& text) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    const std::string digits(text.begin(), end);
    text.remove_prefix(digits.size());
    return digits;
}

bool take_one_of(std::string_view& text, std::string_view characters) {
    if (text.empty() || characters.find(text.front()) == std::string_view::npos) return false;
    text.remove_prefix(1);
    return true;
}

/// Reads an exponent ("e-05") if there is one.
int take_exponent(std::string_view& text) {
    if (!take_one_of(text, "eE")) return 0;
    const bool is_negative = text.starts_with('-');
    take_one_of(text, "+-");
    int exponent = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
    const bool is_number = error == std::errc{} && !text.empty() && is_digit(text.front());
    if (!is_number || exponent > kLargestExponent) throw Unsupported{};
    text.remove_prefix(as_size(end - text.data()));
    return is_negative ? -exponent : exponent;
}

/// At most 18 digits, as an integer.
std::int64_t integer_of(std::string_view digits) {
    std::int64_t value = 0;
    for (const char digit : digits) value = 10 * value + (digit - '0');
    return value;
}

/// A decimal number below 10^18 such as "-12.375" or "1e-05", found without floating point.
struct Decimal {
    bool is_negative = false;
    std::int64_t whole = 0, numerator = 0, denominator = 1;  ///< whole + numerator / denominator, of up to 18 decimals
    bool has_more = false;                                   ///< further decimals, which are left out
};

Decimal read_decimal(std::string_view text) {
    Decimal decimal;
    decimal.is_negative = text.starts_with('-');
    take_one_of(text, "+-");
    std::string digits = take_digits(text);
    std::ptrdiff_t point = std::ssize(digits);
    if (take_one_of(text, ".")) digits += take_digits(text);
    if (digits.empty()) throw Unsupported{};
    point += take_exponent(text);
    if (!text.empty()) throw Unsupported{};
    if (point < 0) digits.insert(0, as_size(-point), '0');
    point = std::max<std::ptrdiff_t>(point, 0);
    digits.resize(std::max(digits.size(), as_size(point)), '0');
    std::string fraction = digits.substr(as_size(point));
    fraction.erase(fraction.find_last_not_of('0') + 1);
    digits.resize(as_size(point));
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
    if (digits.size() > kFractionDigits) throw Unsupported{};
    decimal.whole = integer_of(digits);
    decimal.has_more = fraction.size() > kFractionDigits;
    fraction.resize(std::min(fraction.size(), kFractionDigits));
    decimal.numerator = integer_of(fraction);
    for (std::size_t i = 0; i < fraction.size(); ++i) decimal.denominator *= 10;
    return decimal;
}

/// In units of 2^-fraction_bits, 0 to 48 of them.
struct RoundedDecimal {
    std::int64_t raw = 0;   ///< to the nearest
    bool is_exact = false;  ///< the decimal number is a whole number of units
};

/// Throws Unsupported above `greatest`, with either sign.
RoundedDecimal rounded(const Decimal& decimal, int fraction_bits, std::int64_t greatest) {
    if (decimal.whole > greatest) throw Unsupported{};
    const std::int64_t unit = std::int64_t{1} << fraction_bits;
    const std::int64_t nearest = mul_div(decimal.numerator, unit, decimal.denominator, Rounding::NearestHalfUp);
    const std::int64_t size = decimal.whole * unit + nearest;
    if (size > greatest * unit) throw Unsupported{};
    const bool is_exact =
        !decimal.has_more &&
        compare_products(static_cast<std::uint64_t>(decimal.numerator), static_cast<std::uint64_t>(unit),
                         static_cast<std::uint64_t>(nearest), static_cast<std::uint64_t>(decimal.denominator)) == 0;
    return {decimal.is_negative ? -size : size, is_exact};
}

/// With 62 significant bits.
SoftFloat soft_float_of(const Decimal& decimal) {
    const SoftFloat size = SoftFloat::from(decimal.whole, 0) +
                           SoftFloat::from(decimal.numerator, 0) / SoftFloat::from(decimal.denominator, 0);
    return decimal.is_negative ? -size : size;
}

}  // namespace

Fields::Fields(std::string_view line) : texts_(split(line, " ")) {}

void Fields::expect_end() const {
    if (left() != 0) throw Unsupported{};
}

std::string_view Fields::text() {
    if (left() == 0) throw Unsupported{};
    return texts_[next_++];
}

std::int64_t Fields::integer(std::int64_t least, std::int64_t most) {
    const std::string_view digits = without_plus(text());
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool is_integer = error == std::errc{} && end == digits.data() + digits.size();
    if (!is_integer || value < least || value > most) throw Unsupported{};
    return value;
}

Angle Fields::angle() {
    std::string_view digits = without_plus(text());
    const bool is_negative = digits.starts_with('-');
    if (is_negative) digits.remove_prefix(1);
    if (digits.empty()) throw Unsupported{};
    Angle angle;
    for (const char digit : digits) {
        if (digit < '0' || digit > '9') throw Unsupported{};
        angle = Angle::from_bam(std::int64_t{angle.bam} * 10 + (digit - '0'));
    }
    return is_negative ? -angle : angle;
}

Fixed<std::int32_t, 8> Fields::length() {
    const RoundedDecimal length = rounded(read_decimal(text()), 8, kLargestLength);
    if (!length.is_exact) throw Unsupported{};
    return Fixed<std::int32_t, 8>::from_raw(static_cast<std::int32_t>(length.raw));
}

Vec3<Fixed<std::int32_t, 8>> Fields::point() {
    const auto x = length(), y = length(), z = length();
    return {x, y, z};
}

Texel Fields::texel() {
    return Texel::from_raw(rounded(read_decimal(text()), Texel::kFractionBits, kLargestLength).raw);
}

ModeAndView Fields::mode() {
    ModeAndView result;
    result.mode.width_px = static_cast<std::int32_t>(integer(1, kLargestSize_px));
    result.mode.height_px = static_cast<std::int32_t>(integer(1, kLargestSize_px));
    result.mode.display.numerator = integer(1, kLargestShape);
    result.mode.display.denominator = integer(1, kLargestShape);
    const Decimal degrees = read_decimal(text());
    result.field_of_view = Degrees::from_raw(rounded(degrees, Degrees::kFractionBits, 180).raw);
    result.fine_field_of_view = soft_float_of(degrees);
    if (result.field_of_view <= Degrees{} || result.field_of_view >= Degrees::from_int(180)) throw Unsupported{};
    return result;
}

Projection frame_lens(const ModeAndView& view) {
    const FarProjection fine = make_far_projection(view.mode, view.fine_field_of_view);
    const bool is_held = fixed_of<Multiplier>(fine.x) && fixed_of<Multiplier>(fine.y);
    if (!is_held) throw Unsupported{};
    return make_projection(view.mode, view.field_of_view);
}

std::string format_fixed(std::int64_t raw, int fraction_bits) {
    const std::uint64_t size = detail::magnitude(raw);
    const std::uint64_t fraction_mask = (std::uint64_t{1} << fraction_bits) - 1;
    std::string text = (raw < 0 ? "-" : "") + std::to_string(size >> fraction_bits);
    std::uint64_t fraction = size & fraction_mask;
    if (fraction != 0) text += '.';
    for (; fraction != 0; fraction &= fraction_mask) {
        fraction *= 10;
        text += static_cast<char>('0' + (fraction >> fraction_bits));
    }
    return text;
}

}  // namespace oblong

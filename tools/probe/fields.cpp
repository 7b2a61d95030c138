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

/// The digits before and after the point.
struct Digits {
    bool is_negative = false;
    std::string whole, fraction;
};

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
std::optional<int> take_exponent(std::string_view& text) {
    if (!take_one_of(text, "eE")) return 0;
    const bool is_negative = !text.empty() && text.front() == '-';
    take_one_of(text, "+-");
    int exponent = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
    const bool is_number = error == std::errc{} && !text.empty() && is_digit(text.front());
    if (!is_number || exponent > kLargestExponent) return std::nullopt;
    text.remove_prefix(as_size(end - text.data()));
    return is_negative ? -exponent : exponent;
}

/// Moves the decimal point to the right.
void shift_point(Digits& digits, int places) {
    for (; places > 0; --places) {
        digits.whole += digits.fraction.empty() ? '0' : digits.fraction.front();
        if (!digits.fraction.empty()) digits.fraction.erase(0, 1);
    }
    for (; places < 0; ++places) {
        digits.fraction.insert(digits.fraction.begin(), digits.whole.empty() ? '0' : digits.whole.back());
        if (!digits.whole.empty()) digits.whole.pop_back();
    }
}

void drop_padding(Digits& digits) {
    digits.whole.erase(0, std::min(digits.whole.find_first_not_of('0'), digits.whole.size()));
    digits.fraction.erase(digits.fraction.find_last_not_of('0') + 1);
}

std::optional<Digits> read_digits(std::string_view text) {
    Digits digits;
    digits.is_negative = !text.empty() && text.front() == '-';
    take_one_of(text, "+-");
    digits.whole = take_digits(text);
    if (take_one_of(text, ".")) digits.fraction = take_digits(text);
    if (digits.whole.empty() && digits.fraction.empty()) return std::nullopt;
    const std::optional<int> exponent = take_exponent(text);
    if (!exponent || !text.empty()) return std::nullopt;
    shift_point(digits, *exponent);
    drop_padding(digits);
    return digits;
}

/// At most 18 digits, as an integer.
std::int64_t integer_of(std::string_view digits) {
    std::int64_t value = 0;
    for (const char digit : digits) value = 10 * value + (digit - '0');
    return value;
}

/// Up to 18 decimals.
struct DecimalFraction {
    std::int64_t numerator, denominator = 1;

    explicit DecimalFraction(std::string_view digits) : numerator(integer_of(digits.substr(0, kFractionDigits))) {
        for (std::size_t i = 0; i < std::min(digits.size(), kFractionDigits); ++i) denominator *= 10;
    }
};

/// a * b == c * d, for numbers that are not negative.
bool equal_products(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return compare_products(static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b), static_cast<std::uint64_t>(c),
                            static_cast<std::uint64_t>(d)) == 0;
}

/// A decimal number such as "-12.375" or "1e-05" in units of 2^-fraction_bits, found without floating point.
struct ParsedFixed {
    std::int64_t raw = 0;   ///< to the nearest
    bool is_exact = false;  ///< the decimal number is a whole number of units
};

/// None if the text is not a decimal number, or |value| is 2^(62 - fraction_bits) or more. `fraction_bits` 0 to 48.
std::optional<ParsedFixed> parse_fixed(std::string_view text, int fraction_bits) {
    const std::optional<Digits> digits = read_digits(text);
    if (!digits || digits->whole.size() > kFractionDigits) return std::nullopt;
    const std::int64_t whole = integer_of(digits->whole);
    if (whole >= std::int64_t{1} << (62 - fraction_bits)) return std::nullopt;

    const std::int64_t unit = std::int64_t{1} << fraction_bits;
    const DecimalFraction fraction(digits->fraction);
    const std::int64_t nearest = mul_div(fraction.numerator, unit, fraction.denominator, Rounding::NearestHalfUp);
    const bool is_exact = digits->fraction.size() <= kFractionDigits &&
                          equal_products(fraction.numerator, unit, nearest, fraction.denominator);
    const std::int64_t size = whole * unit + nearest;
    return ParsedFixed{digits->is_negative ? -size : size, is_exact};
}

/// The same with 62 significant bits, of up to 18 decimals; below 10^18.
std::optional<SoftFloat> parse_scaled(std::string_view text) {
    const std::optional<Digits> digits = read_digits(text);
    if (!digits || digits->whole.size() > kFractionDigits) return std::nullopt;
    const DecimalFraction fraction(digits->fraction);
    const SoftFloat size = SoftFloat::from(integer_of(digits->whole), 0) +
                           SoftFloat::from(fraction.numerator, 0) / SoftFloat::from(fraction.denominator, 0);
    return digits->is_negative ? -size : size;
}

ParsedFixed parse_or_refuse(std::string_view text, int fraction_bits, std::int64_t greatest) {
    const std::optional<ParsedFixed> parsed = parse_fixed(text, fraction_bits);
    const std::int64_t limit = greatest * (std::int64_t{1} << fraction_bits);
    if (!parsed || parsed->raw > limit || parsed->raw < -limit) throw Unsupported{};
    return *parsed;
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
    const ParsedFixed parsed = parse_or_refuse(text(), 8, kLargestLength);
    if (!parsed.is_exact) throw Unsupported{};
    return Fixed<std::int32_t, 8>::from_raw(static_cast<std::int32_t>(parsed.raw));
}

Vec3<Fixed<std::int32_t, 8>> Fields::point() {
    const auto x = length(), y = length(), z = length();
    return {x, y, z};
}

Texel Fields::texel() {
    return Texel::from_raw(parse_or_refuse(text(), Texel::kFractionBits, kLargestLength).raw);
}

ModeAndView Fields::mode() {
    ModeAndView result;
    result.mode.width_px = static_cast<std::int32_t>(integer(1, kLargestSize_px));
    result.mode.height_px = static_cast<std::int32_t>(integer(1, kLargestSize_px));
    result.mode.display.numerator = integer(1, kLargestShape);
    result.mode.display.denominator = integer(1, kLargestShape);
    const std::string_view degrees = text();
    result.field_of_view = Degrees::from_raw(parse_or_refuse(degrees, Degrees::kFractionBits, 180).raw);
    result.fine_field_of_view = parse_scaled(degrees).value_or(SoftFloat{});
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

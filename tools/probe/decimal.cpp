#include "tools/probe/decimal.h"

#include <algorithm>
#include <charconv>

#include "engine/fixed/wide.h"

namespace oblong {

namespace {

/// How far an exponent may move the point: further, and the number is 0 or too large, whatever its digits.
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
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
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

}  // namespace

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

std::optional<SoftFloat> parse_scaled(std::string_view text) {
    const std::optional<Digits> digits = read_digits(text);
    if (!digits || digits->whole.size() > kFractionDigits) return std::nullopt;
    const DecimalFraction fraction(digits->fraction);
    const SoftFloat size = SoftFloat::from(integer_of(digits->whole), 0) +
                           SoftFloat::from(fraction.numerator, 0) / SoftFloat::from(fraction.denominator, 0);
    return digits->is_negative ? -size : size;
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

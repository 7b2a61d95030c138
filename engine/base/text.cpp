#include "engine/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace oblong {

namespace {

/// Consumes all digits at the start of `text`; the number uses at most `most` of them.
std::int64_t take_digits(std::string_view& text, int most, int& taken) {
    std::int64_t number = 0;
    taken = 0;
    for (; !text.empty() && text.front() >= '0' && text.front() <= '9'; text.remove_prefix(1)) {
        if (taken == most) continue;
        number = number * 10 + (text.front() - '0');
        ++taken;
    }
    return number;
}

// In UTF-8, of a letter's bytes all but the first.
bool is_inside_letter(char byte) {
    return (byte & 0xc0) == 0x80;
}

// How far the last byte of a small Latin letter is above that of its capital; 0 for any other letter.
int above_capital(char32_t letter) {
    if ((letter >= 'a' && letter <= 'z') || (letter >= 0xe0 && letter < 0xff && letter != 0xf7)) return 0x20;
    if (letter < 0x100 || letter >= 0x17f || letter == 0x131 || letter == 0x140) return 0;
    const bool are_small_even = (letter > 0x138 && letter < 0x14a) || letter > 0x178;
    return (letter % 2 == 0) == are_small_even ? 1 : 0;
}

}  // namespace

char32_t take_letter(std::string_view& text) {
    constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};  // less has fewer bytes
    const char32_t first = static_cast<unsigned char>(text.front());
    const std::size_t size = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    char32_t code = size == 1 ? first : first & (0x7f >> size);
    bool is_letter = size <= text.size() && (first < 0x80 || (first >= 0xc0 && first < 0xf8));
    for (std::size_t i = 1; i < size && is_letter; ++i) {
        is_letter = is_inside_letter(text[i]);
        code = code << 6 | (text[i] & 0x3f);
    }
    is_letter = is_letter && code >= kLeast[size] && code < 0x110000 && (code < 0xd800 || code >= 0xe000);
    text.remove_prefix(is_letter ? size : 1);
    return is_letter ? code : kNoLetter;
}

std::string_view first_letters(std::string_view text, std::size_t most) {
    std::string_view rest = text;
    for (; most > 0 && !rest.empty(); --most) take_letter(rest);
    return text.substr(0, text.size() - rest.size());
}

std::size_t letters_in(std::string_view text) {
    std::size_t count = 0;
    for (; !text.empty(); ++count) take_letter(text);
    return count;
}

std::string level_text(std::string text) {
    bool is_utf8 = true;
    for (std::string_view rest = text; !rest.empty();) is_utf8 &= take_letter(rest) != kNoLetter;
    if (!is_utf8)
        for (char& letter : text) letter &= 0x7f;
    return text;
}

std::string plain_text(std::string text) {
    constexpr std::string_view kMark = "\xef\xbb\xbf";
    if (text.starts_with(kMark)) text.erase(0, kMark.size());
    if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
    return text;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& letter : lower)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return lower;
}

std::string in_capitals(std::string text, std::size_t most) {
    for (std::string_view rest = text; most > 0 && !rest.empty(); --most) {
        const int above = above_capital(take_letter(rest));
        char& last = text[text.size() - rest.size() - 1];
        last = static_cast<char>(last - above);
    }
    return text;
}

std::string shortened(std::string text, std::size_t most) {
    if (text.size() <= most) return text;
    while (most > 0 && is_inside_letter(text[most])) --most;
    return text.replace(most, std::string::npos, "...");
}

std::string bounds_text(std::int64_t from, std::int64_t to) {
    return std::to_string(from) + (to == from ? "" : " to " + std::to_string(to));
}

std::vector<std::string> split(std::string_view text, std::string_view separators) {
    std::vector<std::string> parts;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find_first_of(separators, start), text.size());
        parts.emplace_back(text.substr(start, end - start));
        start = end + 1;
    }
    return parts;
}

bool is_space(char letter) {
    return letter == ' ' || (letter >= '\t' && letter <= '\r');
}

std::optional<std::int64_t> parse_decimal(std::string_view text, int fraction_bits) {
    const bool is_negative = !text.empty() && text.front() == '-';
    if (is_negative || (!text.empty() && text.front() == '+')) text.remove_prefix(1);
    while (text.starts_with("00")) text.remove_prefix(1);

    constexpr int kMostDigits = 12;  // enough to detect numbers that are too large, too few to overflow
    int whole_digits = 0, fraction_digits = 0;
    const std::int64_t whole = take_digits(text, kMostDigits, whole_digits);
    std::int64_t fraction = 0;
    if (!text.empty() && text.front() == '.') {
        text.remove_prefix(1);
        fraction = take_digits(text, 9, fraction_digits);
    }
    if (!text.empty() || whole_digits + fraction_digits == 0 || whole > std::numeric_limits<std::int32_t>::max())
        return std::nullopt;

    std::int64_t denominator = 1;
    for (int i = 0; i < fraction_digits; ++i) denominator *= 10;
    const std::int64_t one = std::int64_t{1} << fraction_bits;
    const std::int64_t magnitude = whole * one + (fraction * one * 2 + denominator) / (denominator * 2);
    return is_negative ? -magnitude : magnitude;
}

namespace {

/// "71.5e-3" as ".0715": the digits, with the point moved. Another text is returned as it is.
std::string without_exponent(std::string_view number) {
    constexpr int kFarthest = 100;  // places: past all digits of any result
    const std::size_t letter = number.find_first_of("eE");
    if (letter == std::string_view::npos) return std::string(number);
    std::string_view power = number.substr(letter + 1);
    if (power.starts_with('+')) power.remove_prefix(1);
    int places = 0;
    const auto [stop, error] = std::from_chars(power.data(), power.data() + power.size(), places);
    std::string digits(number.substr(0, letter));
    const std::size_t point = std::min(digits.find('.'), digits.size());
    digits.erase(point, 1);
    if (error != std::errc() || stop != power.data() + power.size() || digits.empty()) return std::string(number);
    places = std::clamp(places, -kFarthest, kFarthest);
    if (places < 0) digits.insert(0, static_cast<std::size_t>(-places), '0');
    if (places > 0) digits.append(static_cast<std::size_t>(places), '0');
    return digits.insert(point + static_cast<std::size_t>(std::max(places, 0)), 1, '.');
}

}  // namespace

std::optional<std::int64_t> parse_level_number(std::string_view text, int fraction_bits) {
    const bool is_negative = text.starts_with('-');
    if (is_negative || text.starts_with('+')) text.remove_prefix(1);
    if (text.starts_with('-') || text.starts_with('+')) return std::nullopt;
    const std::optional<std::int64_t> magnitude = parse_decimal(without_exponent(text), fraction_bits);
    return magnitude && is_negative ? -*magnitude : magnitude;
}

std::optional<std::vector<std::int64_t>> parse_decimals(std::string_view text, int fraction_bits) {
    std::vector<std::int64_t> numbers;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) {
        const std::optional<std::int64_t> number = parse_level_number(word, fraction_bits);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

std::string_view take_word(std::string_view& text) {
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    std::size_t size = 0;
    while (size < text.size() && !is_space(text[size])) ++size;
    const std::string_view word = text.substr(0, size);
    text.remove_prefix(size);
    return word;
}

}  // namespace oblong

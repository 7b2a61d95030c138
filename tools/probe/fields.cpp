#include "tools/probe/fields.h"

#include <charconv>

#include "tools/probe/decimal.h"
#include "tools/probe/project_far.h"

namespace oblong {

namespace {

constexpr std::int64_t kLargestLength = 32767;
constexpr std::int64_t kLargestSize_px = 32768, kLargestShape = 1 << 20;

/// from_chars knows no plus sign.
std::string_view without_plus(std::string_view text) {
    return text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text;
}

ParsedFixed parse_or_refuse(std::string_view text, int fraction_bits, std::int64_t greatest) {
    const std::optional<ParsedFixed> parsed = parse_fixed(text, fraction_bits);
    const std::int64_t limit = greatest * (std::int64_t{1} << fraction_bits);
    if (!parsed || parsed->raw > limit || parsed->raw < -limit) throw Unsupported{};
    return *parsed;
}

}  // namespace

Fields::Fields(std::string_view line) {
    std::size_t start = 0;
    for (std::size_t end; (end = line.find(' ', start)) != std::string_view::npos; start = end + 1)
        texts_.push_back(line.substr(start, end - start));
    texts_.push_back(line.substr(start));
}

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

}  // namespace oblong

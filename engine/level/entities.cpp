#include "engine/level/entities.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/base/input_error.h"

namespace oblong {

namespace {

bool is_space(char letter) {
    return letter == ' ' || (letter >= '\t' && letter <= '\r');
}
bool is_digit(char letter) {
    return letter >= '0' && letter <= '9';
}

class EntityParser {
  public:
    EntityParser(std::string_view text, std::string_view source, std::int64_t first_offset)
        : text_(text.substr(0, text.find('\0'))), source_(source), first_offset_(first_offset) {}

    std::vector<Entity> parse_all() {
        std::vector<Entity> entities;
        while (skip_space(), position_ < text_.size()) {
            expect('{', "an entity");
            entities.push_back(parse_entity());
        }
        return entities;
    }

  private:
    /// From behind an opening brace up to the closing one.
    Entity parse_entity() {
        Entity entity;
        while (skip_space(), !at('}')) {
            std::string key = parse_quoted("a key or the entity's end");
            skip_space();
            std::string value = parse_quoted("the key's value");
            entity.pairs.emplace_back(std::move(key), std::move(value));
        }
        ++position_;
        entity.pairs.shrink_to_fit();
        return entity;
    }

    std::string parse_quoted(const char* expected) {
        expect('"', expected);
        const std::size_t end = find_closing_quote(text_, position_);
        if (end == std::string_view::npos) fail(position_ - 1, "a quote is not closed, expected another '\"'");
        const std::size_t start = position_;
        position_ = end + 1;
        return std::string(text_.substr(start, end - start));
    }

    void skip_space() {
        while (position_ < text_.size()) {
            const bool is_comment = text_.substr(position_, 2) == "//";
            if (is_comment)
                position_ = std::min(text_.find('\n', position_), text_.size());
            else if (is_space(text_[position_]))
                ++position_;
            else
                return;
        }
    }

    bool at(char letter) const { return position_ < text_.size() && text_[position_] == letter; }

    void expect(char letter, const char* meaning) {
        if (!at(letter)) {
            const std::string found =
                position_ == text_.size() ? "the text ends" : "'" + std::string(1, text_[position_]) + "'";
            fail(position_, found + ", expected '" + letter + "': " + meaning);
        }
        ++position_;
    }

    [[noreturn]] void fail(std::size_t position, const std::string& what_is_wrong) const {
        const std::int64_t offset = first_offset_ + static_cast<std::int64_t>(position);
        throw InputError(std::string(source_) + ", offset " + std::to_string(offset), what_is_wrong);
    }

    std::string_view text_, source_;
    std::int64_t first_offset_;
    std::size_t position_ = 0;
};

/// Consumes all digits at the start of `text`; the number uses at most `most` of them.
std::int64_t take_digits(std::string_view& text, int most, int& taken) {
    std::int64_t number = 0;
    taken = 0;
    for (; !text.empty() && is_digit(text.front()); text.remove_prefix(1)) {
        if (taken == most) continue;
        number = number * 10 + (text.front() - '0');
        ++taken;
    }
    return number;
}

}  // namespace

std::size_t find_closing_quote(std::string_view text, std::size_t start) {
    std::size_t quote = text.find('"', start);
    while (quote != std::string_view::npos && quote > start && text[quote - 1] == '\\') {
        const std::size_t next = text.find_first_of("\"\n", quote + 1);
        if (next == std::string_view::npos || text[next] == '\n') break;
        quote = next;
    }
    return quote;
}

std::vector<Entity> parse_entities(std::string_view text, std::string_view source, std::int64_t first_offset) {
    return EntityParser(text, source, first_offset).parse_all();
}

std::optional<std::int64_t> parse_decimal(std::string_view text, int fraction_bits) {
    const bool is_negative = !text.empty() && text.front() == '-';
    if (is_negative || (!text.empty() && text.front() == '+')) text.remove_prefix(1);

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

std::optional<std::vector<std::int64_t>> parse_decimals(std::string_view text, int fraction_bits) {
    std::vector<std::int64_t> numbers;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) {
        const std::optional<std::int64_t> number = parse_decimal(word, fraction_bits);
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

std::optional<World> parse_world_number(std::string_view text) {
    const auto raw = parse_decimal(text, World::kFractionBits);
    if (!raw || !std::in_range<World::Raw>(*raw)) return std::nullopt;
    return World::from_raw(static_cast<World::Raw>(*raw));
}

std::optional<Vec3<World>> parse_world_vector(std::string_view text) {
    const auto x = parse_world_number(take_word(text));
    const auto y = parse_world_number(take_word(text));
    const auto z = parse_world_number(take_word(text));
    if (!x || !y || !z || !take_word(text).empty()) return std::nullopt;
    return Vec3<World>{*x, *y, *z};
}

std::string Entity::value(const std::string& key, const std::string& otherwise) const {
    for (const auto& [name, value] : pairs)
        if (name == key) return value;
    return otherwise;
}

}  // namespace oblong

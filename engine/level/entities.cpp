#include "engine/level/entities.h"

#include <algorithm>
#include <utility>

#include "engine/base/input_error.h"
#include "engine/base/text.h"

namespace oblong {

namespace {

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

std::optional<World> parse_world_number(std::string_view text) {
    const auto raw = parse_level_number(text, World::kFractionBits);
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

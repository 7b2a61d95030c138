#include "tools/map/source/map_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "engine/level/entities.h"
#include "engine/level/entity_classes.h"
#include "tools/map/source/checks.h"

namespace oblong::map {
namespace {

struct MapToken {
    std::string_view text;  // of the source
    bool is_quoted = false;
    bool is_end = false;
    int line = 1;

    bool is(std::string_view symbol) const { return !is_quoted && !is_end && text == symbol; }
};

// A decimal number; none if all of a text is not one.
std::optional<double> number_of(std::string_view text) {
    double value = 0;
#ifdef __cpp_lib_to_chars
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool is_number = error == std::errc() && stop == end;
#else  // libc++ before 20 has it for integers only
    const std::string copy(text);
    char* stop = nullptr;
    value = std::strtod(copy.c_str(), &stop);
    const bool is_number = copy.find_first_not_of("-.0123456789eE") == copy.npos && stop == copy.c_str() + copy.size();
#endif
    return is_number ? std::optional(value) : std::nullopt;
}

// Cuts the text of a map source into words, brackets and quoted strings; comments run from // to the line's end.
class MapTokens {
  public:
    explicit MapTokens(std::string_view text) : text_(text) { advance(); }

    const MapToken& peek() const { return next_; }

    MapToken take() {
        MapToken taken = next_;
        advance();
        return taken;
    }

    // Takes `symbol`, or throws InputError that expects it `where`.
    void expect(std::string_view symbol, std::string_view where) {
        if (!next_.is(symbol)) fail(next_, "'" + std::string(symbol) + "' " + std::string(where));
        advance();
    }

    double take_number(std::string_view what) {
        constexpr int kFarthest = 1 << 30;  // planes of points so far away are still exact
        const MapToken token = take();
        const std::optional<double> value = number_of(token.text);
        if (token.is_end || !value || !(std::abs(*value) <= kFarthest))
            fail(token, "a number for " + std::string(what) + ", at most " + std::to_string(kFarthest));
        return *value;
    }

    [[noreturn]] void fail(const MapToken& at, std::string_view expected) const {
        const std::string found = at.is_end ? "the file ends" : "found '" + std::string(at.text) + "'";
        throw InputError(at_line(at.line), found + ", expected " + std::string(expected));
    }

  private:
    static bool is_blank(char letter) { return static_cast<unsigned char>(letter) <= ' '; }

    void advance() {
        skip_blanks();
        next_ = MapToken{};
        next_.line = line_;
        next_.is_end = position_ == text_.size();
        if (next_.is_end) return;
        if (text_[position_] == '"')
            read_quoted();
        else
            read_word();
    }

    void skip_blanks() {
        while (position_ < text_.size()) {
            if (is_blank(text_[position_])) {
                if (text_[position_++] == '\n') ++line_;
                continue;
            }
            if (text_[position_] != '/' || text_.substr(position_, 2) != "//") return;
            position_ = std::min(text_.find('\n', position_), text_.size());
        }
    }

    void read_quoted() {
        next_.is_quoted = true;
        const std::string_view line = text_.substr(0, text_.find('\n', position_));
        const std::size_t end = find_closing_quote(line, position_ + 1);
        next_.text = line.substr(position_ + 1, std::min(end, line.size()) - position_ - 1);
        if (end == std::string_view::npos) fail(next_, "a closing '\"' on the same line");
        position_ = end + 1;
    }

    void read_word() {
        constexpr std::string_view kBrackets = "()[]";
        std::size_t end = position_ + 1;
        if (kBrackets.find(text_[position_]) == kBrackets.npos)
            while (end < text_.size() && !is_blank(text_[end]) && text_[end] != ')') ++end;
        next_.text = text_.substr(position_, end - position_);
        position_ = end;
    }

    std::string_view text_;
    std::size_t position_ = 0;
    int line_ = 1;
    MapToken next_;
};

Point take_point(MapTokens& tokens) {
    tokens.expect("(", "before a point");
    const double x = tokens.take_number("x");
    const double y = tokens.take_number("y");
    const double z = tokens.take_number("z");
    tokens.expect(")", "after a point");
    return {x, y, z};
}

// [ x y z offset ], Valve 220.
void take_axis(MapTokens& tokens, Point& axis, double& offset) {
    tokens.expect("[", "before a texture axis");
    for (int i = 0; i < 3; ++i) axis[i] = tokens.take_number("a texture axis");
    offset = tokens.take_number("a texture offset");
    tokens.expect("]", "after a texture axis");
}

TextureFields take_texture(MapTokens& tokens) {
    TextureFields texture;
    const MapToken name = tokens.take();
    if (name.is_end || name.text.empty()) tokens.fail(name, "a texture's name");
    texture.name = lower_case(name.text);
    texture.has_axes = tokens.peek().is("[");
    for (std::size_t i = 0; i < 2; ++i) {
        if (texture.has_axes)
            take_axis(tokens, texture.axes[i], texture.offset[i]);
        else
            texture.offset[i] = tokens.take_number("a texture offset");
    }
    texture.rotation_degrees = tokens.take_number("a texture rotation");
    for (double& scale : texture.scale) {
        scale = tokens.take_number("a texture scale");
        if (scale == 0) scale = 1;  // as editors mean it
    }
    return texture;
}

MapSide take_side(MapTokens& tokens) {
    MapSide side;
    side.line = tokens.peek().line;
    for (Point& point : side.points) point = take_point(tokens);
    const Point normal = cross(side.points[0] - side.points[1], side.points[2] - side.points[1]);
    if (length(normal) < 1e-6)
        throw InputError(at_line(side.line), "the three points of a plane lie on one line, expected a triangle");
    side.texture = take_texture(tokens);
    // Some editors append Quake 2's three numbers.
    const auto is_appended = [&](const MapToken& next) {
        return !next.is_end && next.line == side.line && !next.is("}") && !next.is("(");
    };
    while (is_appended(tokens.peek())) tokens.take();
    return side;
}

MapBrush take_brush(MapTokens& tokens) {
    MapBrush brush;
    brush.line = tokens.peek().line;
    tokens.expect("{", "before a brush");
    while (!tokens.peek().is("}")) {
        if (!tokens.peek().is("("))
            tokens.fail(tokens.peek(), "'(' of a side, or '}' after what begins in line " + std::to_string(brush.line));
        brush.sides.push_back(take_side(tokens));
    }
    tokens.expect("}", "after a brush");
    return brush;
}

void take_pair(MapTokens& tokens, MapEntity& entity) {
    const MapToken key = tokens.take();
    const MapToken value = tokens.take();
    if (!value.is_quoted) tokens.fail(value, "a value in quotes for the key \"" + std::string(key.text) + "\"");
    entity.pairs.push_back({std::string(key.text), std::string(value.text), key.line});
}

MapEntity take_entity(MapTokens& tokens, Warnings* warnings) {
    MapEntity entity;
    entity.line = tokens.peek().line;
    tokens.expect("{", "before an entity");
    while (!tokens.peek().is("}")) {
        if (tokens.peek().is_quoted) {
            take_pair(tokens, entity);
        } else if (tokens.peek().is("{")) {
            entity.brushes.push_back(take_brush(tokens));
            if (!entity.brushes.back().sides.empty()) continue;
            if (warnings != nullptr) warnings->add(entity.brushes.back().line, "a brush without sides is left out");
            entity.brushes.pop_back();
        } else {
            tokens.fail(tokens.peek(), "a key in quotes, '{' of a brush, or '}' after the entity that begins in line " +
                                           std::to_string(entity.line));
        }
    }
    tokens.expect("}", "after an entity");
    return entity;
}

// It would end the entities' text in the level.
void check_no_zero_byte(std::string_view text) {
    const std::size_t zero = text.find('\0');
    if (zero == std::string_view::npos) return;
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
    throw InputError(at_line(line), "a zero byte, expected text");
}

}  // namespace

std::string MapEntity::value(std::string_view key, std::string_view otherwise) const {
    for (const MapPair& pair : pairs)
        if (pair.key == key) return pair.value;
    return std::string(otherwise);
}

bool MapEntity::has(std::string_view key) const {
    return std::any_of(pairs.begin(), pairs.end(), [&](const MapPair& pair) { return pair.key == key; });
}

std::vector<MapEntity> parse_map(std::string_view file, Warnings* warnings) {
    const std::string text = plain_text(std::string(file));
    check_no_zero_byte(text);
    MapTokens tokens(text);
    std::vector<MapEntity> entities;
    while (!tokens.peek().is_end) {
        entities.push_back(take_entity(tokens, warnings));
        if (entities.size() > 1 && role_of(entities.back()) == ClassRole::Worldspawn)
            throw InputError(at_line(entities.back().line),
                             "a second worldspawn, expected one, that of line " + std::to_string(entities[0].line));
    }
    if (entities.empty() || role_of(entities[0]) != ClassRole::Worldspawn)
        throw InputError("line 1", "the first entity is no worldspawn, expected one that holds the world's brushes");
    leave_out_layers(entities);
    return entities;
}

}  // namespace oblong::map

#include "tools/map/map_tokens.h"

#include <charconv>
#include <cmath>

#include "engine/base/input_error.h"

namespace oblong::map {
namespace {

constexpr double kFarthest = 65536;  // no number of a level is larger

bool is_blank(char letter) {
    return static_cast<unsigned char>(letter) <= ' ';
}
bool is_bracket(char letter) {
    return letter == '(' || letter == ')' || letter == '[' || letter == ']';
}

}  // namespace

MapToken MapTokens::take() {
    MapToken taken = next_;
    advance();
    return taken;
}

void MapTokens::expect(std::string_view symbol, std::string_view where) {
    if (!next_.is(symbol)) fail(next_, "'" + std::string(symbol) + "' " + std::string(where));
    advance();
}

double MapTokens::take_number(std::string_view what) {
    const MapToken token = take();
    double value = 0;
    const char* const end = token.text.data() + token.text.size();
    const auto [stop, error] = std::from_chars(token.text.data(), end, value);
    if (token.is_end || error != std::errc() || stop != end || !(std::abs(value) <= kFarthest))
        fail(token, "a number for " + std::string(what));
    return value;
}

void MapTokens::fail(const MapToken& at, std::string_view expected) const {
    const std::string found = at.is_end ? "the file ends" : "found '" + at.text + "'";
    throw InputError("line " + std::to_string(at.line), found + ", expected " + std::string(expected));
}

void MapTokens::advance() {
    skip_blanks();
    next_ = MapToken{};
    next_.line = line_;
    if (position_ == text_.size()) {
        next_.is_end = true;
    } else if (text_[position_] == '"') {
        read_quoted();
    } else {
        read_word();
    }
}

void MapTokens::skip_blanks() {
    while (position_ < text_.size()) {
        if (text_.substr(position_, 2) == "//") {
            position_ = std::min(text_.find('\n', position_), text_.size());
            continue;
        }
        if (!is_blank(text_[position_])) return;
        if (text_[position_++] == '\n') ++line_;
    }
}

void MapTokens::read_quoted() {
    next_.is_quoted = true;
    const std::size_t end = text_.find_first_of("\"\n", position_ + 1);
    next_.text = text_.substr(position_ + 1, std::min(end, text_.size()) - position_ - 1);
    if (end >= text_.size() || text_[end] == '\n') fail(next_, "a closing '\"' on the same line");
    position_ = end + 1;
}

void MapTokens::read_word() {
    std::size_t end = position_ + 1;
    if (!is_bracket(text_[position_])) {
        while (end < text_.size() && !is_blank(text_[end]) && text_[end] != ')') ++end;
    }
    next_.text = text_.substr(position_, end - position_);
    position_ = end;
}

}  // namespace oblong::map

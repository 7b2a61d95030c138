#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

#include "tests/map/editor_formats.h"

namespace oblong::test {
namespace {

using Kind = EditorValue::Kind;

[[noreturn]] void fail(std::size_t at, const std::string& expected) {
    throw std::runtime_error("at " + std::to_string(at) + ": expected " + expected);
}

EditorValue number_value(double number) {
    EditorValue value;
    value.kind = Kind::Number;
    value.number = number;
    return value;
}

EditorValue text_value(std::string text) {
    EditorValue value;
    value.kind = Kind::Text;
    value.text = std::move(text);
    return value;
}

// Keys of entities are texts: in sums and bits they count as numbers.
double number_of(const EditorValue& value) {
    if (value.kind == Kind::Text) return value.text.empty() ? 0 : std::stod(value.text);
    return value.number;
}

// Of the language's operators those that Oblong's files have, the loosest first; they group from the left.
constexpr std::array<std::string_view, 2> kOperators{"->", "&"};

class Expression {
  public:
    Expression(std::string_view text, const EditorVariables& variables) : text_(text), variables_(variables) {}

    EditorValue whole() {
        EditorValue value = level(0);
        if (!is_end()) fail(at_, "the end");
        return value;
    }

  private:
    bool is_end() {
        while (at_ < text_.size()) {
            if (text_.substr(at_, 2) == "//")
                at_ = std::min(text_.find('\n', at_), text_.size());
            else if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
                ++at_;
            else
                return false;
        }
        return true;
    }

    bool is_next(std::string_view symbol) { return !is_end() && text_.substr(at_, symbol.size()) == symbol; }

    bool take(std::string_view symbol) {
        if (!is_next(symbol)) return false;
        at_ += symbol.size();
        return true;
    }

    void expect(std::string_view symbol) {
        if (!take(symbol)) fail(at_, "'" + std::string(symbol) + "'");
    }

    EditorValue level(std::size_t index) {
        if (index == kOperators.size()) return term();
        EditorValue left = level(index + 1);
        while (take(kOperators[index])) left = combined(kOperators[index], left, level(index + 1));
        return left;
    }

    static EditorValue combined(std::string_view symbol, const EditorValue& a, const EditorValue& b) {
        if (symbol == "->") return number_of(a) != 0 ? b : EditorValue{};
        return number_value(static_cast<double>(static_cast<long>(number_of(a)) & static_cast<long>(number_of(b))));
    }

    EditorValue term() {
        if (is_end()) fail(at_, "a value");
        if (take("(")) {
            EditorValue value = level(0);
            expect(")");
            return value;
        }
        if (take("{{")) return first_of("}}");
        if (take("{")) return map();
        if (take("[")) return list("]");
        const char letter = text_[at_];
        if (letter == '"' || letter == '\'') return text_value(quoted());
        if (std::isdigit(static_cast<unsigned char>(letter)) != 0 || letter == '.') return number();
        const std::string name = word();
        for (const char* const literal : {"true", "false", "null"})
            if (name.starts_with(literal)) return literal_value(name, literal);
        const auto known = variables_.find(name);
        return known == variables_.end() ? EditorValue{} : known->second;
    }

    // A name that begins with a literal is two tokens for the editor.
    EditorValue literal_value(const std::string& name, const std::string& literal) const {
        if (name != literal) fail(at_, "a name that does not begin with " + literal);
        EditorValue value = number_value(literal == "true" ? 1 : 0);
        value.kind = literal == "null" ? Kind::Undefined : Kind::Boolean;
        return value;
    }

    EditorValue first_of(std::string_view close) {
        for (const EditorValue& each : list(close).list)
            if (each.kind != Kind::Undefined) return each;
        return {};
    }

    EditorValue list(std::string_view close) {
        EditorValue value;
        value.kind = Kind::List;
        if (take(close)) return value;
        do value.list.push_back(level(0));
        while (take(","));
        expect(close);
        return value;
    }

    EditorValue map() {
        EditorValue value;
        value.kind = Kind::Map;
        if (is_next("}")) {
            close_map();
            return value;
        }
        do {
            const std::string key = is_next("\"") || is_next("'") ? quoted() : word();
            expect(":");
            if (!value.map.emplace(key, level(0)).second) fail(at_, "each key once");
        } while (take(","));
        close_map();
        return value;
    }

    // '}}' is one token, whatever it stands behind.
    void close_map() {
        if (is_next("}}")) fail(at_, "a blank between '}' and '}'");
        expect("}");
    }

    EditorValue number() {
        const std::size_t end = std::min(text_.find_first_not_of("0123456789.", at_), text_.size());
        const std::string rest(text_.substr(at_, end - at_));
        std::size_t length = 0;
        const double value = std::stod(rest, &length);
        at_ += length;
        return number_value(value);
    }

    // A backslash keeps the next letter from ending the string; only it and quotes lose theirs.
    std::string quoted() {
        const char mark = text_[at_++];
        std::string value;
        for (; at_ < text_.size() && text_[at_] != mark; ++at_) {
            if (text_[at_] == '\n') fail(at_, "the string's end");
            if (text_[at_] == '\\' && at_ + 1 < text_.size()) {
                if (text_[at_ + 1] != '"' && text_[at_ + 1] != '\\') value += '\\';
                ++at_;
            }
            value += text_[at_];
        }
        if (at_ == text_.size()) fail(at_, "the string's end");
        ++at_;
        return value;
    }

    std::string word() {
        is_end();
        std::size_t end = at_;
        while (end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) != 0 || text_[end] == '_'))
            ++end;
        if (end == at_) fail(at_, "a name");
        std::string name(text_.substr(at_, end - at_));
        at_ = end;
        return name;
    }

    std::string_view text_;
    const EditorVariables& variables_;
    std::size_t at_ = 0;
};

}  // namespace

const EditorValue& EditorValue::at(const std::string& key) const {
    const auto found = map.find(key);
    if (kind != Kind::Map || found == map.end()) throw std::runtime_error("no member " + key);
    return found->second;
}

const std::string& EditorValue::as_text() const {
    if (kind != Kind::Text) throw std::runtime_error("no text");
    return text;
}

double EditorValue::as_number() const {
    if (kind != Kind::Number) throw std::runtime_error("no number");
    return number;
}

const std::vector<EditorValue>& EditorValue::as_list() const {
    if (kind != Kind::List) throw std::runtime_error("no list");
    return list;
}

EditorValue evaluate(std::string_view text, const EditorVariables& variables) {
    return Expression(text, variables).whole();
}

std::string interpolated(const std::string& text, const EditorVariables& variables) {
    std::string out;
    for (std::size_t at = 0;;) {
        const std::size_t begin = text.find("${", at);
        out += text.substr(at, begin - at);
        if (begin == std::string::npos) return out;
        const std::size_t end = text.find('}', begin);
        if (end == std::string::npos) throw std::runtime_error("no end of ${");
        const EditorValue value = evaluate(text.substr(begin + 2, end - begin - 2), variables);
        out += value.as_text();
        at = end + 1;
    }
}

}  // namespace oblong::test

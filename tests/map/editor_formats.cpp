#include "tests/map/editor_formats.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <sstream>
#include <stdexcept>

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

// The language's operators, the loosest first: of each level, all group from the left.
constexpr std::array<std::array<std::string_view, 6>, 9> kLevels{
    {{"->"}, {"||"}, {"&&"}, {"|"}, {"&"}, {"==", "!="}, {"<=", ">=", "<", ">"}, {"+", "-"}, {"*", "/", "%"}}};

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

    std::string_view take_operator(std::size_t level) {
        for (const std::string_view symbol : kLevels[level]) {
            if (symbol.empty() || !is_next(symbol)) continue;
            if (symbol == "-" && is_next("->")) continue;
            if ((symbol == "|" || symbol == "&") && text_.substr(at_ + 1, 1) == symbol) continue;
            at_ += symbol.size();
            return symbol;
        }
        return "";
    }

    EditorValue level(std::size_t index) {
        if (index == kLevels.size()) return term();
        EditorValue left = level(index + 1);
        for (std::string_view symbol = take_operator(index); !symbol.empty(); symbol = take_operator(index))
            left = combined(symbol, left, level(index + 1));
        return left;
    }

    static EditorValue combined(std::string_view symbol, const EditorValue& a, const EditorValue& b) {
        if (symbol == "->") return number_of(a) != 0 ? b : EditorValue{};
        if (symbol == "==" && a.kind == Kind::Text) return number_value(a.text == b.text);
        const double x = number_of(a), y = number_of(b);
        if (symbol == "||") return number_value(x != 0 || y != 0);
        if (symbol == "&&") return number_value(x != 0 && y != 0);
        if (symbol == "|") return number_value(static_cast<double>(static_cast<long>(x) | static_cast<long>(y)));
        if (symbol == "&") return number_value(static_cast<double>(static_cast<long>(x) & static_cast<long>(y)));
        if (symbol == "==") return number_value(x == y);
        if (symbol == "+") return number_value(x + y);
        if (symbol == "-") {
            if (a.kind == Kind::Undefined || b.kind == Kind::Undefined)
                throw std::runtime_error("a difference of what there is not");
            return number_value(x - y);
        }
        throw std::runtime_error("the operator " + std::string(symbol) + " is not read here");
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

struct FgdToken {
    enum class Kind { End, Whole, Decimal, Word, Text, Symbol } kind = Kind::End;
    std::string text;
};

class Fgd {
  public:
    explicit Fgd(std::string_view text) : text_(text) {}

    std::vector<EditorClass> classes() {
        std::vector<EditorClass> all;
        while (peek().kind != FgdToken::Kind::End) {
            all.push_back(one_class());
            if (!names_.insert(all.back().name).second) fail("each class once: " + all.back().name);
        }
        return all;
    }

  private:
    [[noreturn]] void fail(const std::string& expected) const {
        const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
        throw std::runtime_error("line " + std::to_string(line) + ": expected " + expected);
    }

    void skip_blanks() {
        while (at_ < text_.size()) {
            if (text_.substr(at_, 2) == "//")
                at_ = std::min(text_.find('\n', at_), text_.size());
            else if (std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos)
                ++at_;
            else
                return;
        }
    }

    FgdToken next() {
        skip_blanks();
        if (at_ == text_.size()) return {};
        constexpr std::string_view kSymbols = "()[]=,:";
        if (kSymbols.find(text_[at_]) != std::string_view::npos)
            return {FgdToken::Kind::Symbol, std::string(1, text_[at_++])};
        if (text_[at_] == '"') {
            const std::size_t end = text_.find('"', at_ + 1);
            if (end == std::string_view::npos) fail("the string's end");
            FgdToken token{FgdToken::Kind::Text, std::string(text_.substr(at_ + 1, end - at_ - 1))};
            at_ = end + 1;
            return token;
        }
        const std::size_t end = std::min(text_.find_first_of(" \t\n\r()[]?;:,=", at_), text_.size());
        std::string word(text_.substr(at_, end - at_));
        at_ = end;
        const std::size_t digits = word.find_first_not_of("0123456789", word[0] == '-' ? 1 : 0);
        if (digits == std::string::npos && word != "-") return {FgdToken::Kind::Whole, word};
        const bool is_decimal = word.find_first_not_of("-.0123456789") == std::string::npos;
        return {is_decimal ? FgdToken::Kind::Decimal : FgdToken::Kind::Word, word};
    }

    FgdToken peek() {
        const std::size_t at = at_;
        FgdToken token = next();
        at_ = at;
        return token;
    }

    std::string take(FgdToken::Kind kind, const std::string& what) {
        const FgdToken token = next();
        if (token.kind != kind) fail(what + ", found '" + token.text + "'");
        return token.text;
    }

    bool take_symbol(const std::string& symbol) {
        const FgdToken token = peek();
        if (token.kind != FgdToken::Kind::Symbol || token.text != symbol) return false;
        next();
        return true;
    }

    void expect(const std::string& symbol) {
        if (!take_symbol(symbol)) fail("'" + symbol + "'");
    }

    // Up to the parenthesis that closes the one before it.
    std::string in_parentheses() {
        expect("(");
        const std::size_t begin = at_;
        for (int depth = 1; depth > 0; ++at_) {
            if (at_ == text_.size()) fail("')'");
            depth += text_[at_] == '(' ? 1 : text_[at_] == ')' ? -1 : 0;
        }
        return std::string(text_.substr(begin, at_ - 1 - begin));
    }

    EditorClass one_class() {
        EditorClass its;
        its.kind = take(FgdToken::Kind::Word, "@SolidClass or @PointClass");
        if (its.kind != "@SolidClass" && its.kind != "@PointClass") fail("@SolidClass or @PointClass");
        while (peek().kind == FgdToken::Kind::Word) {
            const std::string property = next().text;
            std::string& value = property == "size" ? its.size : its.model;
            if ((property != "size" && property != "model") || !value.empty()) fail("size or model, once");
            value = in_parentheses();
            if (property == "model") evaluate(value);
            if (property == "size") check_size(value);
        }
        if (its.kind == "@SolidClass" && !(its.size + its.model).empty()) fail("no size and model of brushes");
        expect("=");
        its.name = take(FgdToken::Kind::Word, "a name");
        if (take_symbol(":")) take(FgdToken::Kind::Text, "a description");
        expect("[");
        std::set<std::string> names;
        while (!take_symbol("]")) {
            its.keys.push_back(key());
            if (!names.insert(its.keys.back().name).second) fail("each key once");
        }
        return its;
    }

    void check_size(const std::string& corners) const {
        std::istringstream words(corners);
        std::array<double, 6> numbers{};
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (i == 3 && words.get() != ',') fail("two corners");
            if (!(words >> numbers[i])) fail("six numbers");
        }
        if (!(words >> std::ws).eof()) fail("')' behind two corners");
    }

    EditorKey key() {
        EditorKey its;
        its.name = take(FgdToken::Kind::Word, "a key");
        expect("(");
        its.type = take(FgdToken::Kind::Word, "a type");
        expect(")");
        if (its.type != "flags") {
            if (take_symbol(":")) its.description = take(FgdToken::Kind::Text, "a description");
            if (take_symbol(":")) its.usual = usual(its.type);
        }
        if (its.type == "flags" || its.type == "choices") values(its);
        return its;
    }

    // What the editor reads without a warning.
    std::string usual(const std::string& type) {
        const FgdToken token = next();
        const bool is_whole = token.kind == FgdToken::Kind::Whole, is_text = token.kind == FgdToken::Kind::Text;
        const bool is_right = type == "integer"   ? is_whole
                              : type == "float"   ? is_text || is_whole
                              : type == "choices" ? is_text || is_whole
                                                  : is_text;
        if (!is_right) fail("a default of type " + type);
        if (type == "float" && token.text.find_first_not_of("-.0123456789") != std::string::npos) fail("a number");
        return token.text;
    }

    void values(EditorKey& its) {
        expect("=");
        expect("[");
        while (!take_symbol("]")) {
            const FgdToken value = next();
            const bool is_whole = value.kind == FgdToken::Kind::Whole;
            if (!is_whole && (its.type == "flags" || value.kind != FgdToken::Kind::Text)) fail("a value");
            expect(":");
            if (!its.values.emplace(value.text, take(FgdToken::Kind::Text, "a caption")).second)
                fail("each value once");
            if (its.type == "flags" && take_symbol(":")) take(FgdToken::Kind::Whole, "0 or 1");
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::set<std::string> names_;
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

std::vector<EditorClass> read_fgd(std::string_view text) {
    return Fgd(text).classes();
}

}  // namespace oblong::test

#include <algorithm>
#include <array>
#include <set>
#include <sstream>
#include <stdexcept>

#include "tests/map/editor_formats.h"

namespace oblong::test {
namespace {

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

std::vector<EditorClass> read_fgd(std::string_view text) {
    return Fgd(text).classes();
}

}  // namespace oblong::test

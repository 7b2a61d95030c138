#include "engine/files/json.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "engine/base/text.h"
#include "engine/files/files.h"

namespace oblong {

void JsonValue::refuse(const std::string& what) const {
    throw FileError(file_, where_.empty() ? "/" : where_, what);
}

const std::string& JsonValue::text() const {
    if (type_ != "string") refuse("is " + std::string(type_) + ", expected a text");
    return text_;
}

const JsonValue::Members& JsonValue::members() const {
    if (type_ != "object") refuse("is " + std::string(type_) + ", expected members in { }");
    return parts_;
}

const JsonValue::Members& JsonValue::elements() const {
    if (type_ != "array") refuse("is " + std::string(type_) + ", expected a list in [ ]");
    return parts_;
}

namespace {

constexpr bool is_digit(char letter) {
    return letter >= '0' && letter <= '9';
}

constexpr bool is_half_of_pair(std::uint32_t code) {
    return code >= 0xd800 && code < 0xe000;
}

void append_utf8(std::uint32_t code, std::string& text) {
    const auto append = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) return append(code);
    const int continued = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    append((0xf00u >> (continued + 1) & 0xff) | code >> 6 * continued);
    for (int i = continued - 1; i >= 0; --i) append(0x80 | (code >> 6 * i & 0x3f));
}

}  // namespace

class JsonReader {
  public:
    JsonReader(const std::string& file, std::string_view text)
        : file_(file), text_(text), at_(text.size() - without_byte_order_mark(text).size()) {}

    JsonValue read() {
        JsonValue root = value("", 0);
        if (at_ != text_.size()) refuse("the end of the file");
        return root;
    }

  private:
    [[noreturn]] void refuse(const std::string& expected) const {
        throw FileError(file_, "byte " + std::to_string(at_ + 1), "no JSON, expected " + expected);
    }

    // The end of the text counts as a letter 0, which JSON has nowhere.
    char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    bool take(char letter) {
        if (next() != letter || at_ == text_.size()) return false;
        ++at_;
        return true;
    }
    void expect(char letter) {
        if (!take(letter)) refuse(std::string("'") + letter + "'");
    }
    void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

    JsonValue value(std::string where, int depth) {
        constexpr int kDeepest = 100;
        if (depth > kDeepest) refuse("fewer values in each other");
        skip_space();
        JsonValue read(file_, std::move(where));
        if (next() == '{') {
            read_parts(read, "object", '}', depth);
        } else if (next() == '[') {
            read_parts(read, "array", ']', depth);
        } else if (next() == '"') {
            read.type_ = "string";
            read.text_ = string();
        } else {
            read.type_ = scalar();
        }
        skip_space();
        return read;
    }

    void read_parts(JsonValue& whole, std::string_view type, char end, int depth) {
        whole.type_ = type;
        ++at_;
        skip_space();
        if (take(end)) return;
        do {
            std::string name = end == '}' ? member_name(whole) : std::to_string(whole.parts_.size());
            std::string where = whole.where_ + "/" + name;
            whole.parts_.emplace_back(std::move(name), value(std::move(where), depth + 1));
        } while (take(','));
        expect(end);
    }

    std::string member_name(const JsonValue& whole) {
        skip_space();
        std::string name = string();
        for (const auto& [other, member] : whole.parts_)
            if (other == name) throw FileError(file_, "member \"" + name + "\"", "is there twice, expected each once");
        skip_space();
        expect(':');
        return name;
    }

    // The type of a number or a word.
    std::string_view scalar() {
        constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kWords{
            {{"null", "null"}, {"true", "boolean"}, {"false", "boolean"}}};
        for (const auto& [word, type] : kWords)
            if (text_.substr(at_).starts_with(word)) {
                at_ += word.size();
                return type;
            }
        if (!is_digit(next()) && next() != '-') refuse("a value");
        take('-');
        if (!take('0')) skip_digits();
        if (take('.')) skip_digits();
        if (take('e') || take('E')) {
            if (!take('+')) take('-');
            skip_digits();
        }
        return "number";
    }

    void skip_digits() {
        if (!is_digit(next())) refuse("a digit");
        while (is_digit(next())) ++at_;
    }

    std::string string() {
        expect('"');
        std::string text;
        while (!take('"')) append_utf8(take('\\') ? escaped() : letter(), text);
        return text;
    }

    // After a backslash.
    std::uint32_t escaped() {
        constexpr std::string_view kLetters = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
        if (const std::size_t known = kLetters.find(next()); known != std::string_view::npos) {
            ++at_;
            return static_cast<std::uint32_t>(kMeanings[known]);
        }
        const std::uint32_t code = hexadecimal();
        if (!is_half_of_pair(code)) return code;
        if (code >= 0xdc00) refuse("the first half of a pair");
        expect('\\');
        const std::uint32_t other = hexadecimal();
        if (!is_half_of_pair(other) || other < 0xdc00) refuse("the second half of a pair");
        return 0x10000 + ((code - 0xd800) << 10) + (other - 0xdc00);
    }

    // u and four digits.
    std::uint32_t hexadecimal() {
        expect('u');
        std::uint32_t code = 0;
        for (int i = 0; i < 4; ++i) {
            const char digit = lower_case(text_.substr(at_, 1))[0];
            if (is_digit(digit))
                code = code << 4 | static_cast<std::uint32_t>(digit - '0');
            else if (digit >= 'a' && digit <= 'f')
                code = code << 4 | static_cast<std::uint32_t>(digit - 'a' + 10);
            else
                refuse("a hexadecimal digit");
            ++at_;
        }
        return code;
    }

    // One letter of a text: no control character, and valid UTF-8.
    std::uint32_t letter() {
        const auto byte = [&](std::size_t i) {
            return at_ + i < text_.size() ? static_cast<std::uint8_t>(text_[at_ + i]) : 0u;
        };
        const std::uint32_t first = byte(0);
        if (first < ' ') refuse("'\"' after a text");
        const std::size_t continued = first < 0x80 ? 0 : first < 0xe0 ? 1 : first < 0xf0 ? 2 : 3;
        std::uint32_t code = continued == 0 ? first : first & 0x3fu >> continued;
        for (std::size_t i = 1; i <= continued; ++i) {
            if ((byte(i) & 0xc0) != 0x80) refuse("UTF-8");
            code = code << 6 | (byte(i) & 0x3f);
        }
        constexpr std::array<std::uint32_t, 4> kLeast{0, 0x80, 0x800, 0x10000};
        if ((first >= 0x80 && first < 0xc0) || first > 0xf4 || code < kLeast[continued] || code > 0x10ffff ||
            is_half_of_pair(code))
            refuse("UTF-8");
        at_ += continued + 1;
        return code;
    }

    const std::string& file_;
    std::string_view text_;
    std::size_t at_ = 0;
};

JsonValue parse_json(const std::string& file, std::string_view text) {
    return JsonReader(file, text).read();
}

}  // namespace oblong

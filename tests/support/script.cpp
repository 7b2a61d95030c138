#include "tests/support/script.h"

#include <algorithm>
#include <sstream>

namespace oblong::test {
namespace {

/// The parts of a text that separators part, without spaces around them. What stands in quotes is not parted.
Words parts_of(const std::string& text, char separator) {
    Words parts(1);
    bool is_quoted = false;
    for (const char letter : text) {
        if (letter == '"') is_quoted = !is_quoted;
        if (letter == separator && !is_quoted)
            parts.emplace_back();
        else if (letter != ' ' || is_quoted || (separator != ' ' && !parts.back().empty()))
            parts.back() += letter;
    }
    for (std::string& part : parts) part.erase(part.find_last_not_of(' ') + 1);
    std::erase(parts, "");
    return parts;
}

std::vector<Words> all_words_of(const Words& texts) {
    std::vector<Words> all;
    for (const std::string& text : texts) all.push_back(words_of(text));
    return all;
}

}  // namespace

Words words_of(const std::string& text) {
    Words words = parts_of(text, ' ');
    for (std::string& word : words) std::erase(word, '"');
    return words;
}

std::vector<ScriptLine> script_lines(const std::string& text) {
    std::vector<ScriptLine> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        const std::size_t first = line.find_first_not_of(' ');
        if (first == std::string::npos || line[first] == '#') continue;
        const std::string words = parts_of(line, '#').front();
        std::size_t colon = 0;
        for (bool is_quoted = false; colon < words.size() && (is_quoted || words[colon] != ':'); ++colon)
            is_quoted ^= words[colon] == '"';
        const std::string checks = colon < words.size() ? words.substr(colon + 1) : "";
        lines.push_back(
            {words, all_words_of(parts_of(words.substr(0, colon), ';')), all_words_of(parts_of(checks, ','))});
    }
    return lines;
}

std::string joined(const Words& words, std::size_t first) {
    std::string text;
    for (std::size_t i = first; i < words.size(); ++i) text += (i == first ? "" : " ") + words[i];
    return text;
}

}  // namespace oblong::test

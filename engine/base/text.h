#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace oblong {

/// A file's text without the byte order mark that spreadsheets and some editors put before UTF-8, and with LF for CR if
/// lines end with CR alone, as on old Macs.
inline std::string plain_text(std::string text) {
    constexpr std::string_view kMark = "\xef\xbb\xbf";
    if (text.starts_with(kMark)) text.erase(0, kMark.size());
    if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
    return text;
}

inline std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& letter : lower)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return lower;
}

/// Truncates a text longer than `most`, and appends "...".
inline std::string shortened(std::string text, std::size_t most) {
    if (text.size() > most) text.replace(most, std::string::npos, "...");
    return text;
}

/// The parts of a text between separators (any letter of `separators`): one more than there are separators.
inline std::vector<std::string> split(std::string_view text, std::string_view separators) {
    std::vector<std::string> parts;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find_first_of(separators, start), text.size());
        parts.emplace_back(text.substr(start, end - start));
        start = end + 1;
    }
    return parts;
}

}  // namespace oblong

#pragma once

#include <string>
#include <string_view>

namespace oblong {

/// Removes the byte order mark that spreadsheets and some editors put before UTF-8.
constexpr std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view kMark = "\xef\xbb\xbf";
    return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

/// Truncates a text longer than `most`, and appends "...".
inline std::string shortened(std::string text, std::size_t most) {
    if (text.size() > most) text.replace(most, std::string::npos, "...");
    return text;
}

}  // namespace oblong

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace oblong {

/// A file's text without the byte order mark that spreadsheets and some editors put before UTF-8, and with LF for CR if
/// lines end with CR alone, as on old Macs.
std::string plain_text(std::string text);

std::string lower_case(std::string_view text);
std::string with_capital(std::string text);  ///< its first letter

/// Truncates a text longer than `most`, and appends "...".
std::string shortened(std::string text, std::size_t most);

/// The parts of a text between separators (any letter of `separators`): one more than there are separators.
std::vector<std::string> split(std::string_view text, std::string_view separators);

/// True for a blank, a tab and the ends of lines and pages.
bool is_space(char letter);

/// Removes the first word and the white space before it, and returns the word; empty if there is none.
std::string_view take_word(std::string_view& text);

/// A decimal number such as "-12.5" in fixed point: value * 2^fraction_bits (0 to 32), rounded to nearest, ties away
/// from zero. Fraction digits after the ninth are ignored. None unless the whole text is a number and |value| < 2^31.
std::optional<std::int64_t> parse_decimal(std::string_view text, int fraction_bits);

/// All numbers of a text, by parse_decimal(). None if a word is not a number.
std::optional<std::vector<std::int64_t>> parse_decimals(std::string_view text, int fraction_bits);

}  // namespace oblong

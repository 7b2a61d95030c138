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
/// Makes a text's first letters capitals: `most`, or all.
std::string in_capitals(std::string text, std::size_t most = std::string::npos);

inline constexpr char32_t kNoLetter = 0x110000;
/// Removes the first letter of a text in UTF-8, which is not empty, and returns its code; kNoLetter for a byte that is
/// part of none.
char32_t take_letter(std::string_view& text);
/// The start of a text: all of its letters, or `most`; a byte that is part of none counts as one.
std::string_view first_letters(std::string_view text, std::size_t most);
std::size_t letters_in(std::string_view text);

/// A text of a level: if it is no UTF-8, its letters are taken for Quake's, whose red ones are 128 above the white
/// ones.
std::string level_text(std::string text);

/// Truncates a text longer than `most` bytes, and appends "...".
std::string shortened(std::string text, std::size_t most);

/// "3 to 7", or "3" if that is all.
std::string bounds_text(std::int64_t from, std::int64_t to);

/// The parts of a text between separators (any letter of `separators`): one more than there are separators.
std::vector<std::string> split(std::string_view text, std::string_view separators);

/// True for a blank, a tab and the ends of lines and pages.
bool is_space(char letter);

/// Removes the first word and the white space before it, and returns the word; empty if there is none.
std::string_view take_word(std::string_view& text);

/// A decimal number such as "-12.5" in fixed point: value * 2^fraction_bits (0 to 32), rounded to nearest, ties away
/// from zero. Fraction digits after the ninth are ignored. None unless the whole text is a number and |value| < 2^31.
std::optional<std::int64_t> parse_decimal(std::string_view text, int fraction_bits);

/// The same for a value in a level, which may have an exponent, as tools write it: "-7.1e-15".
std::optional<std::int64_t> parse_level_number(std::string_view text, int fraction_bits);

/// All numbers of a text, by parse_level_number(). None if a word is not a number.
std::optional<std::vector<std::int64_t>> parse_decimals(std::string_view text, int fraction_bits);

}  // namespace oblong

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// Parses a level's entities: a sequence of `{ "key" "value" ... }` up to the end or a zero byte, with white space and
/// `//` comments. Throws InputError whose `where` is `source` and the offset of the error, counted from `first_offset`.
std::vector<Entity> parse_entities(std::string_view text, std::string_view source, std::int64_t first_offset = 0);

/// The position of the quote that ends the quoted text beginning at `start`, or npos. A quote behind a backslash is
/// part of the text, as is the backslash, unless it is the last quote of its line: paths such as "C:\gfx\" end in
/// backslashes.
std::size_t find_closing_quote(std::string_view text, std::size_t start);

/// Removes the first word and the white space before it, and returns the word; empty if there is none.
std::string_view take_word(std::string_view& text);

/// A decimal number such as "-12.5" in fixed point: value * 2^fraction_bits (0 to 32), rounded to nearest, ties away
/// from zero. Fraction digits after the ninth are ignored. None unless the whole text is a number and |value| < 2^31.
std::optional<std::int64_t> parse_decimal(std::string_view text, int fraction_bits);

/// All numbers of a text, by parse_decimal(). None if a word is not a number.
std::optional<std::vector<std::int64_t>> parse_decimals(std::string_view text, int fraction_bits);

/// A decimal number in world units; none if it does not fit.
std::optional<World> parse_world_number(std::string_view text);

/// Three decimal numbers "x y z" in world units, as in an entity's origin. None unless there are three that fit.
std::optional<Vec3<World>> parse_world_vector(std::string_view text);

}  // namespace oblong

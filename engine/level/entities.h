#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// The entities of a level's text: `{ "key" "value" ... }` one after the other, up to the end or a zero byte; white
/// space and `//` comments between them do not count. Throws InputError whose `where` is `source` and the offset of the
/// fault, the text's first byte being `first_offset`.
std::vector<Entity> parse_entities(std::string_view text, std::string_view source, std::int64_t first_offset = 0);

/// The place of the quote that ends the quoted text beginning at `start`, or npos. A quote behind a backslash is part
/// of the text, backslash and all, unless it is the last one of its line: paths such as "C:\gfx\" end in backslashes.
std::size_t find_closing_quote(std::string_view text, std::size_t start);

/// Removes the first word from a text, with the white space before it, and returns it; empty where none is left.
std::string_view take_word(std::string_view& text);

/// A decimal number such as "-12.5" in fixed point: value * 2^fraction_bits (0 to 32), rounded to nearest, a tie away
/// from zero. Digits past the ninth of the fraction are not read. Nothing unless the whole text is a number and
/// |value| < 2^31.
std::optional<std::int64_t> parse_decimal(std::string_view text, int fraction_bits);

/// All numbers of a text, each as parse_decimal() reads it. Nothing if a word of it is no number.
std::optional<std::vector<std::int64_t>> parse_decimals(std::string_view text, int fraction_bits);

/// A decimal number in world units, where it fits.
std::optional<World> parse_world_number(std::string_view text);

/// Three decimal numbers "x y z", as in an entity's origin, in world units. Nothing unless there are three that fit.
std::optional<Vec3<World>> parse_world_vector(std::string_view text);

}  // namespace oblong

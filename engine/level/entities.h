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

/// A decimal number in world units; none if it does not fit.
std::optional<World> parse_world_number(std::string_view text);

/// Three decimal numbers "x y z" in world units, as in an entity's origin. None unless there are three that fit.
std::optional<Vec3<World>> parse_world_vector(std::string_view text);

}  // namespace oblong

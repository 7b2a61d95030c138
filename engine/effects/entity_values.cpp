#include "engine/effects/entity_values.h"

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "engine/level/entities.h"

namespace oblong {

namespace {

std::optional<std::uint8_t> parse_colour(std::string_view text) {
    const std::optional<std::int64_t> number = parse_level_number(text, 0);
    if (!number || *number < 0 || *number > 255) return std::nullopt;
    return static_cast<std::uint8_t>(*number);
}

std::optional<ColourRamp> parse_colours(std::string_view text) {
    const std::size_t space = text.find(' ');
    const auto first = parse_colour(text.substr(0, space));
    const auto last = space == std::string_view::npos ? first : parse_colour(text.substr(space + 1));
    if (!first || !last) return std::nullopt;
    return ColourRamp{*first, *last};
}

bool is_in(const NumberRange& range, World value) {
    return value >= range.least && value <= range.most;
}

}  // namespace

void EntityValues::warn(const std::string& what) const {
    warnings_.push_back(
        printable("entity " + std::to_string(index_) + " (" + entity_.value("classname") + "): " + what));
}

void EntityValues::warn_of(const std::string& key, const std::string& expected) const {
    warn(key + " is \"" + entity_.value(key) + "\", expected " + expected);
}

NumberRange EntityValues::range_of(const std::string& key) const {
    const EntityClass* const its_class = find_entity_class(entity_.value("classname"));
    const EntityKey* const row = its_class ? find_entity_key(*its_class, key) : nullptr;
    return row && row->range ? *row->range : NumberRange{World::lowest(), World::highest()};
}

std::string_view EntityValues::usual(const std::string& key) const {
    return usual_text(entity_.value("classname"), key);
}

World EntityValues::number(const std::string& key, const NumberRange& range) const {
    const std::string text = entity_.value(key);
    const World otherwise = parse_world_number(usual(key)).value_or(World{});
    if (text.empty()) return otherwise;
    const std::optional<World> value = parse_world_number(text);
    if (value && is_in(range, *value)) return *value;
    warn_of(key, "a number from " + range_text(range) + ": it is taken as " + decimal_text(otherwise));
    return otherwise;
}

std::int32_t EntityValues::whole_number(const std::string& key, std::int32_t least, std::int32_t most) const {
    return floor_of(number(key, {World::from_int(least), World::from_int(most)}));
}

std::int32_t EntityValues::period_ms() const {
    const std::int64_t seconds_12 = floor_of<12>(number("period"));
    return static_cast<std::int32_t>((seconds_12 * 1000 + 2048) / 4096);
}

std::optional<Vec3<World>> EntityValues::vector(const std::string& key, const NumberRange& range) const {
    const std::string text = entity_.value(key);
    const std::optional<Vec3<World>> otherwise = parse_world_vector(usual(key));
    if (text.empty()) return otherwise;
    const std::optional<Vec3<World>> value = parse_world_vector(text);
    if (value && is_in(range, value->x) && is_in(range, value->y) && is_in(range, value->z)) return value;
    warn_of(key, "three numbers from " + range_text(range));
    return otherwise;
}

ColourRamp EntityValues::colours(const std::string& key) const {
    const std::string text = entity_.value(key);
    const std::optional<ColourRamp> given = parse_colours(text);
    if (given) return *given;
    if (!text.empty()) warn_of(key, "one or two palette indices from 0 to 255: the default is taken");
    return parse_colours(usual(key)).value_or(ColourRamp{});
}

std::optional<Vec3<World>> EntityValues::origin() const {
    constexpr World kFarthest = World::from_int(65536);
    const std::optional<Vec3<World>> origin = vector("origin", {-kFarthest, kFarthest});
    if (!origin) warn("it has no place, and is left out");
    return origin;
}

}  // namespace oblong

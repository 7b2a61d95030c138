#include <algorithm>
#include <string>

#include "engine/base/text.h"
#include "engine/level/entity_classes.h"
#include "engine/level/level.h"

namespace oblong {
namespace {

std::string list_of(std::span<const KeyValue> values) {
    std::string text;
    for (const KeyValue& value : values) {
        if (!text.empty()) text += &value == &values.back() ? " or " : ", ";
        text += value.value;
    }
    return text;
}

bool is_in_range(const std::string& value, const EntityKey& key) {
    const auto numbers = parse_decimals(value, World::kFractionBits);
    if (!key.range || !numbers) return true;
    return std::all_of(numbers->begin(), numbers->end(), [&](std::int64_t number) {
        return number >= floor_of<12>(key.range->least) && number <= floor_of<12>(key.range->most);
    });
}

bool is_of_kind(const EntityKey& key, const std::string& value) {
    const auto numbers = parse_decimals(value, 0);
    const auto number = parse_level_number(value, 16);
    const auto is_value = [&](const KeyValue& each) {
        return each.value == value || (number && number == parse_level_number(each.value, 16));
    };
    switch (key.kind) {
        case KeyKind::Numbers:
            return numbers && numbers->size() >= key.least && numbers->size() <= key.most;
        case KeyKind::Whole:
        case KeyKind::Flags:
            return numbers && numbers->size() == 1 && value.find_first_of(".eE") == std::string::npos;
        case KeyKind::Choice:
            return std::any_of(key.values.begin(), key.values.end(), is_value);
        case KeyKind::Texture:
            return has_holes(value);
        default:
            return true;
    }
}

}  // namespace

std::string expected_instead_of(const std::string& value, const EntityKey& key) {
    if (is_of_kind(key, value) && is_in_range(value, key)) return "";
    const std::string range = key.range ? " from " + range_text(*key.range) : "";
    if (key.kind == KeyKind::Texture) return "a texture that begins with '{'";
    if (key.kind == KeyKind::Choice) return list_of(key.values);
    if (key.kind == KeyKind::Whole || key.kind == KeyKind::Flags) return "a whole number" + range;
    if (key.most == 1) return "a number" + range;
    const std::string least = std::to_string(key.least), most = std::to_string(key.most);
    return (key.least == key.most ? most : least + " to " + most) + " numbers" + range;
}

std::string decimal_text(World value) {
    const bool is_negative = value < World{};
    const std::int64_t thousandths = (std::int64_t{floor_of<12>(absolute(value))} * 1000 + 2048) / 4096;
    std::string decimals = '.' + std::to_string(thousandths % 1000 + 1000).substr(1);
    decimals.erase(decimals.find_last_not_of(".0") + 1);
    return (is_negative ? "-" : "") + std::to_string(thousandths / 1000) + decimals;
}

std::string range_text(const NumberRange& range) {
    return decimal_text(range.least) + " to " + decimal_text(range.most);
}

}  // namespace oblong

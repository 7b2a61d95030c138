#include "game/options/preference_kinds.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "engine/base/table.h"
#include "engine/files/arguments.h"

namespace oblong {
namespace {

Preference named(PreferenceNames names, std::string values) {
    Preference preference;
    preference.name = std::move(names.name);
    preference.label = std::move(names.label);
    preference.help = std::move(names.help);
    preference.page = names.page;
    preference.keys = std::move(names.keys);
    preference.values = std::move(values);
    return preference;
}

}  // namespace

std::string hundredths_text(std::int32_t value_100) {
    std::string text = std::to_string(value_100 / 100);
    if (value_100 % 100 == 0) return text;
    text += '.' + std::to_string(value_100 % 100 / 10);
    return value_100 % 10 == 0 ? text : text + std::to_string(value_100 % 10);
}

void refuse(const std::string& name, const std::string& text, const std::string& expected) {
    throw UsageError("--" + name + ": '" + text + "', expected " + expected);
}

std::int32_t stepped(const std::vector<std::int32_t>& stops, std::int32_t value, int steps) {
    const auto above = std::upper_bound(stops.begin(), stops.end(), value);
    const auto from = std::lower_bound(stops.begin(), stops.end(), value);
    const auto last = static_cast<std::ptrdiff_t>(stops.size()) - 1;
    const std::ptrdiff_t next = steps > 0 ? above - stops.begin() + steps - 1 : from - stops.begin() + steps;
    return steps == 0 ? value : item(stops, std::clamp<std::ptrdiff_t>(next, 0, last));
}

Preference one_of(PreferenceNames names, std::vector<std::string_view> values,
                  std::function<int(const Preferences&)> get, std::function<void(Preferences&, int)> set) {
    Preference preference = named(std::move(names), listed(values));
    const int count = static_cast<int>(values.size());
    preference.text = [values, get](const Preferences& of) { return std::string(item(values, get(of))); };
    preference.shown = preference.text;
    preference.parse = [values, set, name = preference.name](Preferences& of, const std::string& text) {
        set(of, static_cast<int>(parse_choice("--" + name, text, values)));
    };
    preference.change = [count, get, set](Preferences& of, int steps) {
        set(of, ((get(of) + steps) % count + count) % count);
    };
    return preference;
}

Preference on_or_off(PreferenceNames names, bool Preferences::*field) {
    Preference preference = one_of(
        std::move(names), {"off", "on"}, [field](const Preferences& of) { return int{of.*field}; },
        [field](Preferences& of, int value) { of.*field = value != 0; });
    preference.is_switch = true;
    // CLI11 passes a flag without a value as "true".
    preference.parse = [parse = preference.parse](Preferences& of, const std::string& text) {
        parse(of, text == "true" ? "on" : text == "false" ? "off" : text);
    };
    return preference;
}

Preference whole_number(PreferenceNames names, std::int32_t Preferences::*field, std::int32_t least,
                        std::int32_t greatest, std::vector<std::int32_t> stops, std::string unit) {
    Preference preference = named(std::move(names), std::to_string(least) + " to " + std::to_string(greatest));
    preference.text = [field](const Preferences& of) { return std::to_string(of.*field); };
    preference.shown = [field, unit](const Preferences& of) { return std::to_string(of.*field) + unit; };
    preference.parse = [=, name = preference.name, values = preference.values](Preferences& of,
                                                                               const std::string& text) {
        std::int32_t value = 0;
        const char* const end = text.data() + text.size();
        const auto [stopped, error] = std::from_chars(text.data(), end, value);
        if (error != std::errc{} || stopped != end || value < least || value > greatest) refuse(name, text, values);
        of.*field = value;
    };
    preference.change = [field, stops](Preferences& of, int steps) { of.*field = stepped(stops, of.*field, steps); };
    return preference;
}

Preference light_in_hundredths(PreferenceNames names, std::int32_t Light::*field, std::int32_t least_100,
                               std::int32_t greatest_100, std::vector<std::int32_t> stops_100) {
    Preference preference =
        named(std::move(names), hundredths_text(least_100) + " to " + hundredths_text(greatest_100));
    preference.text = [field](const Preferences& of) { return hundredths_text(of.light_of(kMuseum).*field); };
    preference.shown = [field](const Preferences& of) { return std::to_string(of.light().*field) + " %"; };
    preference.parse = [=, name = preference.name, values = preference.values](Preferences& of,
                                                                               const std::string& text) {
        const std::int64_t value_16 = parse_number("--" + name, text, 16);
        const std::int64_t value_100 = (value_16 * 100 + (1 << 15)) >> 16;
        if (value_16 * 100 < std::int64_t{least_100} << 16 || value_16 * 100 > std::int64_t{greatest_100} << 16)
            refuse(name, text, values);
        Light light = of.light();
        light.*field = static_cast<std::int32_t>(value_100);
        of.set_light(light);
    };
    preference.change = [field, stops_100](Preferences& of, int steps) {
        Light light = of.light();
        light.*field = stepped(stops_100, light.*field, steps);
        of.set_light(light);
    };
    return preference;
}

}  // namespace oblong

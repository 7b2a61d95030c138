#include "game/options/preference_kinds.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/programs/arguments.h"

namespace oblong {

Preference named(PreferenceNames names, std::string values) {
    Preference preference;
    static_cast<PreferenceNames&>(preference) = std::move(names);
    preference.values = std::move(values);
    return preference;
}

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

Preference as_switch(Preference preference) {
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
        const std::optional<std::int64_t> value_16 = parse_decimal(text, 16);
        if (!value_16 || *value_16 * 100 < std::int64_t{least_100} << 16 ||
            *value_16 * 100 > std::int64_t{greatest_100} << 16)
            refuse(name, text, values);
        Light light = of.light();
        light.*field = static_cast<std::int32_t>((*value_16 * 100 + (1 << 15)) >> 16);
        of.set_light(light);
    };
    preference.change = [field, stops_100](Preferences& of, int steps) {
        Light light = of.light();
        light.*field = stepped(stops_100, light.*field, steps);
        of.set_light(light);
    };
    return preference;
}

namespace {

using Texts = std::vector<std::string>;
using Key = std::int64_t (*)(const Preferences&);

bool is_drawable(const Preferences& preferences) {
    return is_drawable(make_projection(preferences.mode, preferences.field_of_view));
}

// The preferences with the next of `stops`, ordered by `key`, that can be drawn; unchanged if there is none.
Preferences with_next(const Preferences& now, const Texts& stops, const Preference& preference, Key key, bool is_up) {
    const auto is_before = [&](const Preferences& a, const Preferences& b) {
        return is_up ? key(a) < key(b) : key(a) > key(b);
    };
    std::optional<Preferences> next;
    for (const std::string& stop : stops) {
        Preferences tried = now;
        preference.parse(tried, stop);
        if (is_drawable(tried) && is_before(now, tried) && (!next || is_before(tried, *next))) next = tried;
    }
    return next.value_or(now);
}

void step_through(const Texts& stops, Key key, Preference& preference) {
    preference.change = [stops, key, parsing = preference](Preferences& of, int steps) {
        for (; steps > 0; --steps) of = with_next(of, stops, parsing, key, true);
        for (; steps < 0; ++steps) of = with_next(of, stops, parsing, key, false);
    };
}

std::string size_text(const Preferences& of) {
    return std::to_string(of.mode.width_px) + "x" + std::to_string(of.mode.height_px);
}

std::string display_text(const Preferences& of) {
    return std::to_string(of.mode.display.numerator) + ":" + std::to_string(of.mode.display.denominator);
}

// Degrees with the fewest decimals that are read as the same value.
std::string degrees_text(Degrees degrees) {
    constexpr int kMostDecimals = 10;  // finer than the 32 fraction bits that are read
    std::int64_t unit = 1;
    for (int decimals = 0;; ++decimals, unit *= 10) {
        const std::int64_t whole = degrees.raw >> 48, rest_32 = (degrees.raw >> 16) & 0xffff'ffff;
        const std::int64_t rounded = whole * unit + ((rest_32 * unit + (std::int64_t{1} << 31)) >> 32);
        std::string text = std::to_string(rounded / unit);
        if (decimals > 0) {
            const std::string digits = std::to_string(rounded % unit);
            text += '.' + std::string(as_size(decimals) - digits.size(), '0') + digits;
        }
        if (decimals == kMostDecimals || parse_field_of_view(text) == degrees) return text;
    }
}

}  // namespace

Preference mode_preference() {
    Preference mode =
        named({"mode", "Resolution", "WxH, size of the picture in pixels; upright windows show 320x200 as 200x320"},
              "8x8 to " + std::to_string(kLargestMode_px) + "x" + std::to_string(kLargestMode_px));
    mode.text = mode.shown = size_text;
    mode.parse = [](Preferences& of, const std::string& text) { parse_mode_size(text, of.mode); };
    step_through(
        {"160x100", "320x200", "320x240", "320x400", "360x480", "400x300", "512x384", "640x350", "640x400", "640x480",
         "800x600", "1024x768", "1280x1024", "1600x1200"},
        [](const Preferences& of) {
            return (std::int64_t{of.mode.width_px} * of.mode.height_px << 13) + of.mode.width_px;
        },
        mode);
    return mode;
}

Preference display_preference() {
    Preference display = named({"display", "Display shape", "W:H, shape of the display that the picture is for"},
                               "1:100 to 100:1, such as 4:3");
    display.text = display.shown = display_text;
    display.parse = [](Preferences& of, const std::string& text) { of.mode.display = parse_display(text); };
    step_through(
        {"5:4", "4:3", "3:2", "8:5", "16:9", "37:20", "21:9"},
        [](const Preferences& of) { return (of.mode.display.numerator << 32) / of.mode.display.denominator; }, display);
    return display;
}

Preference field_of_view_preference() {
    Preference field = named({"fov", "Field of view", "horizontal field of view, in degrees"}, "1 to 179");
    field.text = [](const Preferences& of) { return degrees_text(of.field_of_view); };
    field.shown = [](const Preferences& of) { return degrees_text(of.field_of_view) + " degrees"; };
    field.parse = [](Preferences& of, const std::string& text) { of.field_of_view = parse_field_of_view(text); };
    Texts stops;
    for (int degrees = 30; degrees <= 140; degrees += 5) stops.push_back(std::to_string(degrees));
    step_through(
        stops, [](const Preferences& of) { return of.field_of_view.raw; }, field);
    return field;
}

}  // namespace oblong

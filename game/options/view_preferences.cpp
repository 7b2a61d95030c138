#include <optional>
#include <vector>

#include "engine/base/table.h"
#include "engine/files/arguments.h"
#include "game/options/preference_kinds.h"

namespace oblong {
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
    Preference mode;
    mode.name = "mode";
    mode.label = "Resolution";
    mode.help = "WxH, size of the picture in pixels";
    mode.values = "8x8 to " + std::to_string(kLargestMode_px) + "x" + std::to_string(kLargestMode_px);
    mode.page = PreferencePage::Picture;
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
    Preference display;
    display.name = "display";
    display.label = "Display shape";
    display.help = "W:H, shape of the display that the picture is for";
    display.values = "1:100 to 100:1, such as 4:3";
    display.page = PreferencePage::Picture;
    display.text = display.shown = display_text;
    display.parse = [](Preferences& of, const std::string& text) { of.mode.display = parse_display(text); };
    step_through(
        {"5:4", "4:3", "3:2", "8:5", "16:9", "37:20", "21:9"},
        [](const Preferences& of) { return (of.mode.display.numerator << 32) / of.mode.display.denominator; }, display);
    return display;
}

Preference field_of_view_preference() {
    Preference field;
    field.name = "fov";
    field.label = "Field of view";
    field.help = "horizontal field of view, in degrees";
    field.values = "1 to 179";
    field.page = PreferencePage::Picture;
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

#include "game/options/preference_table.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/base/input_error.h"
#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/programs/arguments.h"
#include "game/options/preference_kinds.h"

namespace oblong {
namespace {

using Rows = std::vector<Preference>;

// "stretch" is the older name of a display shape, `fill`, and not a scaling mode.
Preference scaling_preference() {
    std::vector<std::string_view> names;
    for (int i = 0; i < kScalingCount; ++i) names.emplace_back(name_of(static_cast<Scaling>(i)));
    Preference row =
        one_of({"scaling", "Scaling", "how pixels of the picture become pixels of the window", "{scaling}"}, names,
               &Preferences::scaling);
    row.values += "; stretch: aspect-display fill";
    row.parse = [parse = row.parse](Preferences& of, const std::string& text) {
        if (text == "stretch")
            of.shown_as = ShownAs::FillWindow;
        else
            parse(of, text);
    };
    return row;
}

Preference tube_preference() {
    Preference row = on_or_off(
        {"tube-light", "CRT colours", "dark colours as bright as on a CRT of 1996; stored for each game"},
        [](const Preferences& of) { return int{of.light().is_of_tube}; },
        [](Preferences& of, int value) {
            Light light = of.light();
            light.is_of_tube = value != 0;
            of.set_light(light);
        });
    row.text = [](const Preferences& of) { return of.light_of(kMuseum).is_of_tube ? "on" : "off"; };
    return row;
}

Rows picture_rows() {
    return {
        field_of_view_preference(),
        mode_preference(),
        display_preference(),
        whole_number({"view-size", "View size", "of the picture, in per cent; the rest is a border",
                      "{smaller-view}, {larger-view}"},
                     &Preferences::size_100, 30, 100, {30, 40, 50, 60, 70, 80, 90, 100}, " %"),
        on_or_off({"double-columns", "Double columns", "draws half of the view's columns, each two pixels wide"},
                  &Preferences::doubles_columns),
        one_of(
            {"aspect-projection", "Drawn for", "pixels that the projection assumes: the display's, or square ones",
             "{projection-aspect}"},
            {"square", "display"}, [](const Preferences& of) { return int{of.corrects_projection}; },
            [](Preferences& of, int value) { of.corrects_projection = value != 0; }),
        one_of({"aspect-display", "Shown as", "shape in the window: the display's, with square pixels, or the window's",
                "{display-aspect}"},
               {"display", "square", "fill"}, &Preferences::shown_as),
        scaling_preference(),
        on_or_off({"crt", "CRT look", "scanlines, shadow mask and glow of a CRT", "{crt}"}, &Preferences::has_crt_look),
        light_in_hundredths(
            {"brightness", "Brightness", "of light on surfaces; stored for each game", "{darker}, {brighter}"},
            &Light::brightness_100, 25, 800, {25, 35, 50, 70, 100, 140, 200, 280, 400, 560, 800}),
        light_in_hundredths({"gamma", "Gamma", "above 1, dark colours are brighter; stored for each game"},
                            &Light::gamma_100, 50, 200,
                            {50, 60, 70, 80, 90, 100, 110, 120, 130, 140, 150, 160, 170, 180, 190, 200}),
        tube_preference(),
        on_or_off({"dac6", "VGA colours", "6 bits a channel: differ by up to 3 of 255 from the palette"},
                  &Preferences::has_dac6),
        on_or_off({"whole-screen", "Full screen", "covers the whole screen (Alt+Enter)"}, &Preferences::fills_screen),
        on_or_off({"vsync", "Vertical sync", "shows each picture whole, where the system can"},
                  &Preferences::waits_for_display),
        whole_number({"frame-cap", "Frame cap", "most pictures a second; 0: no limit"}, &Preferences::frame_cap_hz, 0,
                     1000, {0, 30, 35, 60, 70, 75, 90, 120, 144, 165, 240}, " a second")};
}

// "preset" if a dial has the value of its preset; then a change of the preset changes it, too.
Preference dial_preference(const Dial& dial) {
    Preference row = named({"dial-" + std::string(dial.name), std::string(dial.caption),
                            std::string(dial.about.substr(0, dial.about.find_last_not_of('.') + 1))},
                           values_of(dial) + ", or preset: as --accuracy sets it");
    row.text = [&dial](const Preferences& of) {
        const std::int32_t value = dial.get(of.accuracy);
        return value == dial.get(accuracy_of(of.preset)) ? "preset" : value_text(dial, value);
    };
    row.shown = [&dial](const Preferences& of) { return value_text(dial, dial.get(of.accuracy)); };
    row.parse = [&dial](Preferences& of, const std::string& text) {
        if (text == "preset") return dial.set(of.accuracy, dial.get(accuracy_of(of.preset)));
        parse_dial(std::string(dial.name) + "=" + text, of.accuracy);
    };
    row.change = [&dial](Preferences& of, int steps) { turn(dial, steps, of.accuracy); };
    return row;
}

Preference machine_preference() {
    constexpr int kToday = static_cast<int>(kProcessors.size());
    return one_of(
        {"machine", "Machine", "each picture stays as long as a 386/33, 486/66 or Pentium/90 takes for it",
         "{machine}"},
        {"386", "486", "pentium", "today"},
        [](const Preferences& of) { return of.machine ? static_cast<int>(*of.machine) : kToday; },
        [](Preferences& of, int value) {
            of.machine = value == kToday ? std::optional<Processor>() : static_cast<Processor>(value);
        });
}

Rows accuracy_rows() {
    std::vector<std::string_view> presets;
    for (const Preset preset : kPresets) presets.emplace_back(name_of(preset));
    Rows rows{one_of(
                  {"accuracy", "Accuracy", "preset of all dials: what games of a year did, or a bound of the error",
                   "{accuracy}"},
                  presets, [](const Preferences& of) { return static_cast<int>(of.preset); },
                  [](Preferences& of, int value) {
                      of.preset = static_cast<Preset>(value);
                      of.accuracy = accuracy_of(of.preset);
                  }),
              machine_preference()};
    for (const Dial& dial : all_dials()) rows.push_back(dial_preference(dial));
    return rows;
}

Rows comfort_rows() {
    const std::vector<std::int32_t> sways{0, 25, 50, 75, 100, 150, 200};
    return {
        one_of({"flashes", "Flashes", "flickering lights, colour changes and flashes"}, {"full", "reduced", "off"},
               &Preferences::flashes),
        whole_number({"view-bob", "View bob", "the view moves up and down while walking; 100: as in Quake"},
                     &Preferences::view_bob_100, 0, 200, sways, " %"),
        whole_number({"view-roll", "View roll", "the view rolls while stepping sideways; 100: as in Quake"},
                     &Preferences::view_roll_100, 0, 200, sways, " %"),
        whole_number({"game-speed", "Game speed", "in per cent; below 100 the same happens more slowly"},
                     &Preferences::game_speed_100, 25, 1600, {25, 33, 50, 67, 75, 80, 90, 100}, " %"),
        whole_number({"text-size", "Text size", "1 or 2: scale of the letters"}, &Preferences::text_scale, 1, 2, {1, 2},
                     "x"),
        one_of({"colours", "Overlay colours", "of lines, maps, keys and text; two sets for colour-blind players"},
               {"standard", "red-green", "blue-yellow"}, &Preferences::colours),
        on_or_off({"captions", "Sound captions", "shows each sound as a line of text"}, &Preferences::shows_captions)};
}

Rows control_rows() {
    const std::vector<std::int32_t> stops{10,  20,  30,  40,  50,  60,  70,  80,  90,  100, 120,
                                          140, 160, 180, 200, 250, 300, 400, 500, 700, 1000};
    return {whole_number({"mouse-sensitivity", "Mouse sensitivity", "in per cent"}, &Preferences::mouse_sensitivity_100,
                         10, 1000, stops, " %"),
            on_or_off({"invert-look", "Invert look", "mouse or stick forward looks down"}, &Preferences::inverts_look),
            on_or_off({"always-run", "Always run", "off: walks slowly, and the key to walk slowly runs"},
                      &Preferences::always_runs),
            whole_number({"gamepad-sensitivity", "Stick sensitivity", "of the stick that turns, in per cent"},
                         &Preferences::gamepad_sensitivity_100, 10, 400,
                         {10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 120, 140, 160, 180, 200, 250, 300, 400}, " %"),
            whole_number({"gamepad-dead-zone", "Stick dead zone",
                          "how far a stick may rest from its centre, in per cent of its range"},
                         &Preferences::gamepad_dead_zone_100, 0, 90, {0, 5, 10, 15, 20, 25, 30, 40, 50, 60, 70, 80, 90},
                         " %")};
}

Rows sound_rows() {
    const std::vector<std::int32_t> tenths{0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
    return {
        whole_number({"volume", "Master volume", "in per cent; 0: no sound device is opened"}, &Preferences::volume_100,
                     0, 100, tenths, " %"),
        whole_number({"sounds-volume", "Sounds", "in the level and in menus, in per cent"},
                     &Preferences::sounds_volume_100, 0, 100, tenths, " %"),
        whole_number({"music-volume", "Music", "in per cent"}, &Preferences::music_volume_100, 0, 100, tenths, " %")};
}

// The light of all games except the museum, which has its own options: "quake:1.4:1:on", a word for each game.
KeptValue lights_value() {
    KeptValue value =
        named({"game-lights", "Light of games", "brightness, gamma and tube-light of games that are not the museum"},
              "GAME:BRIGHTNESS:GAMMA:on or off, with spaces between games, or none");
    value.text = [](const Preferences& of) {
        std::string text;
        for (const auto& [game, light] : of.lights)
            if (game != kMuseum)
                text += (text.empty() ? "" : " ") + game + ':' + hundredths_text(light.brightness_100) + ':' +
                        hundredths_text(light.gamma_100) + (light.is_of_tube ? ":on" : ":off");
        return text.empty() ? "none" : text;
    };
    value.parse = [values = value.values](Preferences& of, const std::string& text) {
        Preferences read;
        std::string_view games = text == "none" ? std::string_view{} : text;
        for (std::string_view word = take_word(games); !word.empty(); word = take_word(games)) {
            const std::vector<std::string> parts = split(word, ":");
            if (parts.size() != 4 || parts[0].empty() || parts[0] == kMuseum)
                refuse("game-lights", std::string(word), values);
            read.game = parts[0];
            for (const auto& [name, part] :
                 {std::pair("brightness", parts[1]), {"gamma", parts[2]}, {"tube-light", parts[3]}})
                preference_named(name).parse(read, part);
        }
        if (const auto museum = of.lights.find(kMuseum); museum != of.lights.end()) read.lights.insert(*museum);
        of.lights = read.lights;
    };
    return value;
}

// For each action, its keys and buttons.
std::vector<KeptValue> binding_values() {
    std::vector<KeptValue> values;
    for (const ActionRow& action : all_actions()) {
        KeptValue value = named({"bind-" + std::string(action.name), std::string(action.label),
                                 "the keys and buttons that do it, named after their places on a US keyboard"},
                                "names with spaces between them, or none");
        value.text = [&action](const Preferences& of) { return inputs_to_text(of.bindings, action.action); };
        value.parse = [&action, name = value.name](Preferences& of, const std::string& text) {
            try {
                set_inputs(of.bindings, action.action, text);
            } catch (const InputError& error) {
                throw UsageError("--" + name + ": " + error.what());
            }
        };
        values.push_back(value);
    }
    return values;
}

Rows make_rows() {
    Rows rows;
    const auto add = [&rows](PreferencePage page, Rows more) {
        for (Preference& row : more) row.page = page;
        rows.insert(rows.end(), more.begin(), more.end());
    };
    add(PreferencePage::Picture, picture_rows());
    add(PreferencePage::Accuracy, accuracy_rows());
    add(PreferencePage::Comfort, comfort_rows());
    add(PreferencePage::Controls, control_rows());
    add(PreferencePage::Sound, sound_rows());
    return rows;
}

}  // namespace

const char* name_of(PreferencePage page) {
    constexpr std::array<const char*, kPreferencePageCount> kNames{"Picture", "Accuracy", "Comfort", "Controls",
                                                                   "Sound"};
    return item(kNames, page);
}

std::span<const Preference> all_preferences() {
    static const Rows rows = make_rows();
    return rows;
}

const Preference& preference_named(std::string_view name) {
    const auto rows = all_preferences();
    return *std::find_if(rows.begin(), rows.end(), [&](const Preference& row) { return row.name == name; });
}

std::span<const KeptValue* const> all_kept_values() {
    static const KeptValue lights = lights_value();
    static const std::vector<KeptValue> bindings = binding_values();
    static const std::vector<const KeptValue*> values = [] {
        std::vector<const KeptValue*> all;
        for (const Preference& preference : all_preferences()) all.push_back(&preference);
        all.push_back(&lights);
        for (const KeptValue& binding : bindings) all.push_back(&binding);
        return all;
    }();
    return values;
}

}  // namespace oblong

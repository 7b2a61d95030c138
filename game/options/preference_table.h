#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "game/options/preferences.h"

namespace oblong {

/// The page of the options menu that shows a preference.
enum class PreferencePage : std::uint8_t { Picture, Accuracy, Comfort, Controls, Sound };
inline constexpr int kPreferencePageCount = 5;

/// "Picture", "Accuracy", "Comfort", "Controls", "Sound".
const char* name_of(PreferencePage page);

/// What a value is called.
struct PreferenceNames {
    std::string name;       ///< in the file, and after "--" on the command line: "mouse-sensitivity"
    std::string label;      ///< at most 20 characters: "Mouse sensitivity"
    std::string help;       ///< one line
    std::string keys = "";  ///< that change it in the game, for KeyNames::in(): "{scaling}"; may be empty
};

/// One value of the options file, and how it is written and read.
struct KeptValue : PreferenceNames {
    std::string values;  ///< the valid ones: "10 to 1000", "off or on"

    /// The value, as parse() reads it: "80", "on", "preset".
    std::function<std::string(const Preferences&)> text;
    /// Sets the value. Throws UsageError, `--NAME: 'TEXT', expected VALUES`, without a change.
    std::function<void(Preferences&, const std::string& text)> parse;
};

/// A value that a menu also shows and changes.
struct Preference : KeptValue {
    PreferencePage page = PreferencePage::Picture;
    bool is_switch = false;  ///< its values are "on" and "off"

    /// The value as a menu shows it, at most 20 characters: "80 %", "on", "every16".
    std::function<std::string(const Preferences&)> shown;
    /// Moves the value by `steps`, negative: back. Numbers stop at their ends, names wrap around.
    std::function<void(Preferences&, int steps)> change;
};

/// All preferences, grouped by page in the page's order. They must be read in this order: a preset before its dials.
std::span<const Preference> all_preferences();
/// The preference of a name, which must exist.
const Preference& preference_named(std::string_view name);
/// All values of the file, in its order: all preferences, "game-lights", and for each action "bind-NAME",
/// its inputs.
std::span<const KeptValue* const> all_kept_values();

}  // namespace oblong

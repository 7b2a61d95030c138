#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/options/preferences.h"

namespace oblong {

/// The page of the options menu that shows a preference.
enum class PreferencePage : std::uint8_t { Picture, Accuracy, Comfort, Controls, Sound };
inline constexpr int kPreferencePageCount = 5;

/// "Picture", "Accuracy", "Comfort", "Controls", "Sound".
const char* name_of(PreferencePage page);

/// One value of the options file: what it is called and how it is written and read.
struct KeptValue {
    std::string name;    ///< in the file, and after "--" on the command line: "mouse-sensitivity"
    std::string label;   ///< at most 20 characters: "Mouse sensitivity"
    std::string help;    ///< one line
    std::string values;  ///< which there are: "10 to 1000", "off or on"

    /// The value, as parse() reads it: "80", "on", "preset".
    std::function<std::string(const Preferences&)> text;
    /// Sets the value. Throws UsageError, `--NAME: 'TEXT', expected VALUES`, and changes nothing then.
    std::function<void(Preferences&, const std::string& text)> parse;
};

/// One that a menu shows and changes too.
struct Preference : KeptValue {
    PreferencePage page = PreferencePage::Picture;
    bool is_switch = false;  ///< its values are "on" and "off"
    std::string keys;        ///< what changes it in the game, for KeyNames::in(): "{scaling}"; may be empty

    /// The value as a menu shows it, at most 20 characters: "80 %", "on", "every16".
    std::function<std::string(const Preferences&)> shown;
    /// Sets the value so many steps on (negative: back). Numbers stop at their ends, names go round.
    std::function<void(Preferences&, int steps)> change;
};

/// All of them: those of a page follow each other, in the order in which the page shows them. Reading them in this
/// order gives what was written: a preset comes before its dials.
std::span<const Preference> all_preferences();
/// The one of a name that there is.
const Preference& preference_named(std::string_view name);
/// All that is kept in the file, in its order: all preferences, and for each action "bind-NAME", what it is bound to.
std::span<const KeptValue* const> all_kept_values();

}  // namespace oblong

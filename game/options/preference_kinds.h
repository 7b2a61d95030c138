#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "game/options/preference_table.h"

namespace oblong {

/// A value with these names, and a description of the valid ones, which is to be completed.
Preference named(PreferenceNames names, std::string values);

/// Makers of the table's rows, one for each kind of preference.

/// A whole number from `least` to `greatest`; a menu stops at `stops`, in rising order.
Preference whole_number(PreferenceNames names, std::int32_t Preferences::*field, std::int32_t least,
                        std::int32_t greatest, std::vector<std::int32_t> stops, std::string unit);

/// A decimal number of the current game's light, kept in hundredths; all numbers here are in hundredths. In the file it
/// is the museum's value; those of other games are in "game-lights".
Preference light_in_hundredths(PreferenceNames names, std::int32_t Light::*field, std::int32_t least_100,
                               std::int32_t greatest_100, std::vector<std::int32_t> stops_100);

/// One of some names; get() and set() use its index.
Preference one_of(PreferenceNames names, std::vector<std::string_view> values,
                  std::function<int(const Preferences&)> get, std::function<void(Preferences&, int)> set);

/// An enumeration from 0 on.
template <class Part, class Enum>
Preference one_of(PreferenceNames names, std::vector<std::string_view> values, Enum Part::*field) {
    return one_of(
        std::move(names), std::move(values),
        [field](const Preferences& preferences) { return static_cast<int>(preferences.*field); },
        [field](Preferences& preferences, int value) { preferences.*field = static_cast<Enum>(value); });
}

/// A switch: a preference that is one of "off" and "on".
Preference as_switch(Preference preference);

template <class... Access>
Preference on_or_off(PreferenceNames names, Access... access) {
    return as_switch(one_of(std::move(names), {"off", "on"}, access...));
}

/// Throws the error of a text that is no value of a preference.
[[noreturn]] void refuse(const std::string& name, const std::string& text, const std::string& expected);

/// Moves `steps` along `stops`, which rise, and stops at the ends. A value between two stops is next to both.
std::int32_t stepped(const std::vector<std::int32_t>& stops, std::int32_t value, int steps);

/// 140: "1.4".
std::string hundredths_text(std::int32_t value_100);

/// These three together decide what is in the picture; a change skips values that cannot be drawn with the other two.
Preference mode_preference();
Preference display_preference();
Preference field_of_view_preference();

}  // namespace oblong

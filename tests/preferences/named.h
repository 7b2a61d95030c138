#pragma once

#include <stdexcept>
#include <string>

#include "game/options/preference_table.h"

namespace oblong::test {

inline const Preference& preference_named(const std::string& name) {
    for (const Preference& row : all_preferences())
        if (row.name == name) return row;
    throw std::logic_error("no preference " + name);
}

/// Preferences of which none has its usual value.
inline Preferences all_changed() {
    Preferences preferences;
    for (const Preference& row : all_preferences()) {
        const std::string usual = row.shown(Preferences{});
        for (const int steps : {1, -1, 2, -2, 0}) {
            Preferences changed = preferences;
            row.change(changed, steps);
            if (row.shown(changed) == usual || (row.text(changed) == "preset" && steps != 0)) continue;
            preferences = changed;
            break;
        }
    }
    return preferences;
}

}  // namespace oblong::test

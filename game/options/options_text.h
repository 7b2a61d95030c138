#pragma once

#include <string>
#include <vector>

#include "game/options/preference_table.h"

namespace oblong {

/// The text of an options file: lines NAME = VALUE and comments. Names that this version does not know stay in it.

/// A line that cannot be read; the others are used.
struct LineFault {
    std::size_t line;  ///< from 1
    std::string what;  ///< what is wrong, what was expected
};

struct ReadPreferences {
    Preferences preferences;
    std::vector<LineFault> faults;  ///< in the order of their lines
};

/// The preferences of a text, with defaults for missing names. The last line of a name counts. Throws InputError if
/// this is no text.
ReadPreferences read_preferences(const std::string& text);

/// A complete text: each value below its help.
std::string write_preferences(const Preferences& preferences);

/// The text with the current values of some options. Options that it lacks are added at its end; nothing else changes.
std::string with_values(const std::string& text, const std::vector<const KeptValue*>& changed, const Preferences& now);

}  // namespace oblong

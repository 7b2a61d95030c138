#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "game/options/preference_table.h"

namespace oblong {

/// A line of an options file (NAME = VALUE, or a comment) that cannot be read; the others are used.
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

/// The text with the current values of some options. Options that it lacks are added at its end; nothing else changes:
/// names that this version does not know stay in it.
std::string with_values(const std::string& text, const std::vector<const KeptValue*>& changed, const Preferences& now);

/// The player's preferences in their file. Values from the command line are not written to it; changes in the game are.
class PreferencesStore {
  public:
    /// Without a file: nothing is read or written.
    PreferencesStore() = default;
    /// Reads a file; if there is none, it is made at the first change. A file that cannot be read, has more than 256
    /// KiB or is no text is not written either: faults() reports it.
    explicit PreferencesStore(std::string file);

    /// The preferences in the file.
    const Preferences& kept() const { return kept_; }
    /// Messages about the file: `FILE: line 12: what is wrong, what was expected`.
    const std::vector<std::string>& faults() const { return faults_; }

    /// Sets the preferences that the game begins with: kept(), changed by the command line.
    void begin_with(const Preferences& preferences) { shown_ = settled_ = preferences; }

    /// Writes what has changed since the game began, if anything has. Returns "", or the error; the next call tries
    /// again.
    std::string save(const Preferences& now);
    /// The same once nothing has changed for a second; after an error only once more has changed. Call it each frame.
    std::string save_when_settled(const Preferences& now, std::uint64_t now_us);

  private:
    void note_changes(const Preferences& now);

    std::string file_;  // empty: none
    Preferences kept_, shown_, settled_;
    std::uint64_t settled_us_ = 0;           // the time of settled_
    std::vector<const KeptValue*> changed_;  // since the file was written
    std::vector<std::string> faults_;
};

}  // namespace oblong

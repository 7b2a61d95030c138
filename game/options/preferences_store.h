#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "game/options/preference_table.h"

namespace oblong {

/// The player's preferences in their file. What is given on the command line is not written to it; what is changed in
/// the game is.
class PreferencesStore {
  public:
    /// Without a file: nothing is read or written.
    PreferencesStore() = default;
    /// Reads a file; where there is none, it is made when something has changed. A file that can't be read, or has
    /// more than 256 KiB, or is no text, is left alone from then on: faults() says so.
    explicit PreferencesStore(std::string file);

    /// As they stand in the file.
    const Preferences& kept() const { return kept_; }
    /// Messages about the file: `FILE: line 12: what is wrong, what was expected`.
    const std::vector<std::string>& faults() const { return faults_; }

    /// What the game begins with: kept(), changed by the command line.
    void begin_with(const Preferences& preferences) { shown_ = settled_ = preferences; }

    /// Writes what has changed since the game began, if anything has. The message if that failed, else "": then it is
    /// tried again only after another change.
    std::string save(const Preferences& now);
    /// The same once nothing has changed for a second: for each frame.
    std::string save_when_settled(const Preferences& now, std::uint64_t now_us);

  private:
    void note_changes(const Preferences& now);

    std::string file_;  // empty: none
    Preferences kept_, shown_, settled_;
    std::uint64_t settled_us_ = 0;           // when settled_ was seen first
    std::vector<const KeptValue*> changed_;  // since the file was written
    std::vector<std::string> faults_;
};

}  // namespace oblong

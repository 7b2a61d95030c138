#pragma once

#include <memory>
#include <string>
#include <vector>

#include "game/level/level_search.h"
#include "game/level/load.h"
#include "game/menu/menu_pages.h"
#include "game/options/options.h"

namespace oblong {

/// The game that is played: the museum, one with its own folder, or levels without a game. Knows its levels, their
/// order and its texts.
class PlayedGame {
  public:
    /// `first`: the level that the program begins with; `options` outlive it.
    PlayedGame(const Options& options, const LoadedLevel& first);

    const GameDefinition& definition() const { return *files_.game; }
    /// The files for loading later levels, without a level.
    const LevelFiles& files() const { return files_; }
    /// Its title in capitals, and its credits with the program's.
    std::string title() const;
    std::string credits() const;
    bool is_museum(const Palette& palette) const;

    /// All levels; `played` is the current one.
    std::vector<LevelEntry> levels(const LoadedLevel& played) const;
    /// The file of the next level. Throws FileError.
    std::string next_file(const LoadedLevel& played, const GameState& state) const;
    /// The figures of a walk that ended.
    EndFigures end_figures(const LoadedLevel& played, const GameState& state) const;

    /// A level by its file; "": the game's first level, or the demo level. The current level is not read again. Throws
    /// FileError.
    std::shared_ptr<const LoadedLevel> load(const std::string& file,
                                            const std::shared_ptr<const LoadedLevel>& played) const;
    /// The museum's level; `played`, if it is that. Throws FileError.
    std::shared_ptr<const LoadedLevel> museum(const std::shared_ptr<const LoadedLevel>& played) const;
    /// The file of the music that a level's world names; empty: none. Prints on standard error where it is missing.
    std::string music_of(const LoadedLevel& level) const;

  private:
    std::string next_level(const LoadedLevel& played, const GameState& state) const;
    LevelPlaces places(const LoadedLevel& played) const;
    const LevelFiles& files_beside(const LoadedLevel& played) const;

    const Options& options_;
    const LevelFiles files_;
};

/// "3:12"
std::string time_text(std::int64_t ticks);

}  // namespace oblong

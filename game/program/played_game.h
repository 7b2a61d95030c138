#pragma once

#include <memory>
#include <string>
#include <vector>

#include "game/level/level_search.h"
#include "game/level/load.h"
#include "game/menu/menu_pages.h"
#include "game/options/options.h"

namespace oblong {

/// The music that a level's world names.
struct LevelMusic {
    std::string file;   ///< empty: none
    std::string fault;  ///< if the named file is missing
};

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
    /// The name of the next level; empty if there is none.
    std::string next_level(const LoadedLevel& played, const GameState& state) const;
    /// The file of a level by its name. Throws FileError.
    std::string find(const std::string& name, const LoadedLevel& played) const;
    /// The figures of a walk that ended.
    EndFigures end_figures(const LoadedLevel& played, const GameState& state) const;

    /// A level by its file; "": the game's first level, or the demo level. The current level is not read again. Throws
    /// FileError.
    std::shared_ptr<const LoadedLevel> load(const std::string& file,
                                            const std::shared_ptr<const LoadedLevel>& played) const;
    /// The museum's level; `played`, if it is that. Throws FileError.
    std::shared_ptr<const LoadedLevel> museum(const std::shared_ptr<const LoadedLevel>& played) const;
    LevelMusic music_of(const LoadedLevel& level) const;

  private:
    LevelPlaces places(const LoadedLevel& played) const;
    const LevelFiles& files_beside(const LoadedLevel& played) const;

    const Options& options_;
    const LevelFiles files_;
};

/// "3:12"
std::string time_text(std::int64_t ticks);

}  // namespace oblong

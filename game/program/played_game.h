#pragma once

#include <memory>
#include <string>
#include <vector>

#include "game/level/level_search.h"
#include "game/level/loaded_level.h"
#include "game/menu/menu_host.h"
#include "game/options/options.h"

namespace oblong {

/// The music that a level's world names.
struct LevelMusic {
    std::string file;   ///< empty: none
    std::string fault;  ///< where the one that is named is not there
};

/// The game that is played: the museum, one with a folder of its own, or levels of nobody. Where its levels are, what
/// follows what, and what it says of itself.
class PlayedGame {
  public:
    /// `first`: the level that the program begins with; `options` outlive it.
    PlayedGame(const Options& options, std::string assets_folder, const LoadedLevel& first);

    const GameDefinition& definition() const { return *files_.game; }
    /// The files that levels to come are loaded with, without a level.
    const LevelFiles& files() const { return files_; }
    /// Its title in capitals, and what its credits and the program's say.
    std::string title() const;
    std::string credits() const;
    bool is_museum(const Palette& palette) const;

    /// All levels, while one is played.
    std::vector<LevelEntry> levels(const LoadedLevel& played) const;
    /// Where the level of a walk leads: a level's name, empty where there is none.
    std::string next_level(const LoadedLevel& played, const GameState& state) const;
    /// The file of a level by its name. Throws FileError.
    std::string find(const std::string& name, const LoadedLevel& played) const;
    /// How a walk ended.
    EndFigures end_figures(const LoadedLevel& played, const GameState& state) const;

    /// A level by its file; "": the one that the options name. The one that is played is not read twice. Throws
    /// FileError.
    std::shared_ptr<const LoadedLevel> load(const std::string& file,
                                            const std::shared_ptr<const LoadedLevel>& played) const;
    LevelMusic music_of(const LoadedLevel& level) const;

  private:
    LevelPlaces places(const LoadedLevel& played) const;
    const LevelFiles& files_beside(const LoadedLevel& played) const;

    const Options& options_;
    const std::string assets_folder_;
    const LevelFiles files_;
};

/// "3:12"
std::string time_text(std::int64_t ticks);

}  // namespace oblong

#include "game/program/played_game.h"

#include <filesystem>

#include "engine/base/text.h"
#include "engine/io/files.h"
#include "engine/level/entity_classes.h"
#include "engine/programs/arguments.h"
#include "game/program/program_files.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

std::string value_of_world(const Level& level, const std::string& key) {
    for (const Entity& entity : level.entities)
        if (role_of(entity) == ClassRole::Worldspawn) return entity.value(key);
    return {};
}

// Finds the next level, if it is another one, or why it cannot be played.
void find_next(const std::string& name, const LevelPlaces& places, EndFigures& figures) {
    try {
        const std::string file = find_named_level(name, places);
        std::error_code ignored;
        if (file != places.beside && !fs::equivalent(file, places.beside, ignored)) figures.next_level = name;
    } catch (const FileError& fault) {
        figures.fault = fault.what();
    }
}

}  // namespace

std::string time_text(std::int64_t ticks) {
    const std::int64_t seconds = ticks / kTicksPerSecond;
    const std::string rest = std::to_string(seconds % 60);
    return std::to_string(seconds / 60) + (rest.size() < 2 ? ":0" : ":") + rest;
}

PlayedGame::PlayedGame(const Options& options, const LoadedLevel& first)
    : options_(options), files_(files_of_game(first, options)) {}

std::string PlayedGame::title() const {
    return in_capitals(definition().title);
}

std::string PlayedGame::credits() const {
    const GameDefinition& game = definition();
    const std::string own = game.credits.empty() ? "" : game.title + "\n\n" + game.credits + "\n\n";
    return own +
           "Oblong " OBLONG_VERSION
           "\n\nA world of 320x200 pixels in the right shape.\n\n"
           "The program: the MIT licence. Textures, models, palette, level, sounds and music of the museum were made "
           "for Oblong and may be used under CC0 1.0 or MIT.\n\n"
           "Levels and models of Quake belong to id Software, or to who made them; none comes with Oblong.\n\n"
           "It stands on SDL (zlib licence), libpng (libpng licence), zlib (zlib licence), CLI11 "
           "(BSD licence), JSON for Modern C++, tinyobjloader and stb (MIT licence).\n\n"
           "What it does was learnt from Casey Muratori, Michael Abrash and the texts that the README names.";
}

bool PlayedGame::is_museum(const Palette& palette) const {
    const std::string museum = (fs::path(files_.assets) / "palette.lmp").string();
    return fs::exists(museum) && read_parsed(museum, read_palette).colours == palette.colours;
}

// The files that the level was loaded with; the demo level belongs to no game.
const LevelFiles& PlayedGame::files_beside(const LoadedLevel& played) const {
    return played.files.level.empty() ? files_ : played.files;
}

LevelPlaces PlayedGame::places(const LoadedLevel& played) const {
    return {played.data.level_file, files_beside(played).game_folders};
}

std::vector<LevelEntry> PlayedGame::levels(const LoadedLevel& played) const {
    std::vector<LevelEntry> entries;
    if (is_game_folder(options_.game)) {
        for (const std::string& level : definition().levels)
            entries.push_back({level, level_file_of(definition(), level), ""});
        return entries;
    }
    const fs::path museum = fs::path(files_.assets) / kDemoLevelFile;
    std::error_code ignored;
    const LevelList list = list_levels(places(played));
    for (const std::string& problem : list.problems) print_fault("oblong", problem);
    for (const ListedLevel& level : list.levels)
        if (level.file.empty())
            entries.push_back({level.name, "", "the museum"});
        else if (!fs::equivalent(level.file, museum, ignored))
            entries.push_back({level.name, level.file, ""});
    return entries;
}

// The name that the exit names, or that of the game's next level; empty if there is none.
std::string PlayedGame::next_level(const LoadedLevel& played, const GameState& state) const {
    const std::string named(next_map(played.level, state));
    return named.empty() ? level_after(definition(), played.data.level_file) : named;
}

std::string PlayedGame::next_file(const LoadedLevel& played, const GameState& state) const {
    return find_named_level(next_level(played, state), places(played));
}

EndFigures PlayedGame::end_figures(const LoadedLevel& played, const GameState& state) const {
    EndFigures figures;
    figures.message = end_message(played.level, state);
    if (figures.message.empty()) figures.message = own_words(definition(), kReachedEnd);
    figures.time = time_text(state.tick);
    if (played.level.secrets > 0)
        figures.secrets = "Secrets found: " + std::to_string(state.progress.found_secrets) + " of " +
                          std::to_string(played.level.secrets);
    if (const std::string missed = missed_secrets(played.level, state); !missed.empty())
        figures.missed = "Missed: " + missed;
    figures.is_lost = state.is_lost();
    const std::string next = figures.is_lost ? "" : next_level(played, state);
    if (!next.empty()) find_next(next, places(played), figures);
    if (const Goal goal = goal_of(played.level, state); !goal.count.empty())
        figures.lenses = goal.title + " found: " + goal.count;
    return figures;
}

// A palette named for another level is not used for the demo level.
std::shared_ptr<const LoadedLevel> PlayedGame::load(const std::string& file,
                                                    const std::shared_ptr<const LoadedLevel>& played) const {
    if (file.empty() && played->files.level.empty()) return played;
    LevelFiles files = file.empty() ? files_ : files_beside(*played);
    files.level = file;
    if (file.empty() && !(options_.level + options_.map).empty()) files.palette.clear();
    return std::make_shared<const LoadedLevel>(files);
}

std::shared_ptr<const LoadedLevel> PlayedGame::museum(const std::shared_ptr<const LoadedLevel>& played) const {
    const fs::path file = fs::path(files_.assets) / kDemoLevelFile;
    std::error_code ignored;
    if (played->data.level_file == file || fs::equivalent(played->data.level_file, file, ignored)) return played;
    return std::make_shared<const LoadedLevel>(LevelFiles{"", "", files_.assets, "", {}, nullptr, files_.load});
}

// From worldspawn's "music": a file below the folder of the game, or beside the level.
std::string PlayedGame::music_of(const LoadedLevel& level) const {
    const std::string named = value_of_world(level.data.level, "music");
    if (named.empty()) return "";
    const std::string file =
        find_below({definition().folder, fs::path(level.data.level_file).parent_path().string()}, named);
    if (file.empty())
        print_fault("oblong", level.data.level_file + ": worldspawn: there is no file " + named +
                                  " for its music, expected one in " + definition().folder);
    return file;
}

}  // namespace oblong

// What the menu's pages ask of the program and have it do.
#include <exception>
#include <filesystem>
#include <optional>
#include <utility>

#include "engine/files/arguments.h"
#include "engine/files/files.h"
#include "game/level/level_search.h"
#include "game/program/program.h"
#include "game/simulation/items.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

// Where a level leads: to another than the one that is played, or why not.
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

LevelPlaces Program::places() const {
    return {level_below().data.level_file, game_files().game_folders};
}

std::vector<LevelEntry> Program::levels() const {
    std::vector<LevelEntry> entries;
    if (is_game_folder(options_.game)) {
        for (const std::string& level : game_.levels) entries.push_back({level, level_file_of(game_, level), ""});
        return entries;
    }
    const fs::path museum = fs::path(assets_folder_) / kDemoLevelFile;
    std::error_code ignored;
    const LevelList list = list_levels(places());
    for (const std::string& problem : list.problems) print_fault("oblong", problem);
    for (const ListedLevel& level : list.levels)
        if (level.file.empty())
            entries.push_back({level.name, "", "the museum"});
        else if (!fs::equivalent(level.file, museum, ignored))
            entries.push_back({level.name, level.file, ""});
    return entries;
}

EndFigures Program::end_figures() const {
    const GameLevel& level = walk_->loaded().level;
    const GameState& state = walk_->state();
    EndFigures figures{std::string(end_message(level, state)), time_text(state.tick), "", "", ""};
    const std::string next = next_level();
    if (!next.empty()) find_next(next, places(), figures);
    if (const Goal found = goal(); !found.count.empty()) figures.lenses = found.title + " found: " + found.count;
    return figures;
}

std::string Program::game_title() const {
    std::string title = game_.title;
    for (char& letter : title)
        if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
    return title;
}

// Where the level's end leads, or else the next one of the game.
std::string Program::next_level() const {
    const std::string named(next_map(walk_->loaded().level, walk_->state()));
    return named.empty() ? level_after(game_, walk_->loaded().data.level_file) : named;
}

Goal Program::goal() const {
    return walk_ ? goal_of(walk_->loaded().level, walk_->state()) : Goal{};
}

void Program::try_with_files(const std::string& what, const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& error) {
        pages_.open_message(what, error.what());
    }
}

const LevelFiles& Program::game_files() const {
    const LevelFiles& files = level_below().files;
    return files.level.empty() ? level_files_ : files;
}

// The one that is up is not read twice. A palette that was named for another level is none of the demo level's.
std::shared_ptr<const LoadedLevel> Program::loaded_as(const std::string& level) {
    if (level.empty() && level_below().files.level.empty()) return screens_.front()->shared_level();
    LevelFiles files = level.empty() ? level_files_ : game_files();
    files.level = level;
    if (level.empty() && !(options_.level + options_.map).empty()) files.palette.clear();
    return std::make_shared<const LoadedLevel>(files);
}

void Program::walk() {
    if (const auto first = std::move(first_walk_))
        return start(std::move(first->loaded), std::move(first->input),
                     options_.replay.empty() ? SessionKind::Walk : SessionKind::Replay);
    try_with_files("Walk", [&] { start_walk(loaded_as("")); });
}

void Program::play_level(const std::string& file) {
    try_with_files("Levels", [&] { leave_walk([this, loaded = loaded_as(file)] { start_walk(loaded); }); });
}

void Program::play_next() {
    try_with_files("Levels", [&] { start_walk(loaded_as(find_named_level(next_level(), places()))); });
}

void Program::restart() {
    leave_walk([this] { start_walk(walk_->shared_level()); });
}

void Program::show_gallery() {
    menu_.close_all();
    screens_.push_back(std::make_unique<Gallery>(screen().shared_level(), settings_, view_options_, platform_));
}

void Program::show_title() {
    leave_walk([this] { try_with_files("Title", [this] { start_title(loaded_as("")); }); });
}

void Program::leave() {
    leave_walk([this] { has_left_ = true; });
}

void Program::keep_recorded() {
    if (walk_ && walk_->input().records() && !recorded_) recorded_ = std::make_unique<Demo>(walk_->input().recorded());
}

std::string Program::credits() const {
    const std::string own = game_.credits.empty() ? "" : game_.title + "\n\n" + game_.credits + "\n\n";
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

}  // namespace oblong

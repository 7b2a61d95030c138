// What the menu's pages ask of the program and have it do.
#include <exception>
#include <filesystem>
#include <optional>
#include <utility>

#include "engine/platform/files.h"
#include "game/level_search.h"
#include "game/program.h"
#include "game/saves/saved_level.h"
#include "game/simulation/items.h"
#include "tools/common/arguments.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

std::string time_text(std::int64_t ticks) {
    const std::int64_t seconds = ticks / kTicksPerSecond;
    const std::string rest = std::to_string(seconds % 60);
    return std::to_string(seconds / 60) + (rest.size() < 2 ? ":0" : ":") + rest;
}

std::string level_title(const std::string& file) {
    return fs::path(file).stem().string();
}

MenuPicture picture_of(const Thumbnail& thumbnail) {
    MenuPicture picture{Thumbnail::kWidth_px, Thumbnail::kHeight_px, {}};
    picture.pixels.reserve(thumbnail.pixels.size());
    for (const std::uint8_t index : thumbnail.pixels) picture.pixels.push_back(thumbnail.palette.colours[index]);
    return picture;
}

SaveEntry entry_of(const SlotContent& content) {
    SaveEntry entry;
    entry.name = name_of(content.slot);
    entry.content = "empty";
    entry.help = content.refusal;
    entry.is_saved_to_by_player = content.slot >= SaveSlot::FirstNumbered;
    entry.has_game = content.game.has_value();
    if (!content.game) return entry;
    entry.content = level_title(content.game->level.name) + " " + time_text(content.game->state.tick);
    if (content.is_former) entry.help = "The one saved before it. " + content.refusal;
    entry.picture = picture_of(content.game->picture);
    return entry;
}

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

// The museum where it is now, should the program have moved since.
std::string level_file_of(const SavedGame& game) {
    std::error_code ignored;
    const bool is_museum = fs::path(game.level.name).filename() == kDemoLevelFile;
    return is_museum && !fs::exists(game.level.name, ignored) ? "" : game.level.name;
}

}  // namespace

LevelPlaces Program::places() const {
    return {session_->loaded().data.level_file, level_files_.game_folders};
}

std::vector<LevelEntry> Program::levels() const {
    std::vector<LevelEntry> entries;
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

std::vector<SaveEntry> Program::saves() const {
    std::vector<SaveEntry> entries;
    if (!has_saves()) return entries;
    for (const SlotContent& content : slots_.list()) entries.push_back(entry_of(content));
    return entries;
}

EndFigures Program::end_figures() const {
    const GameLevel& level = session_->loaded().level;
    const GameState& state = session_->state();
    EndFigures figures{std::string(end_message(level, state)), time_text(state.tick), "", "", ""};
    const std::string next(next_map(level, state));
    if (!next.empty()) find_next(next, places(), figures);
    figures.lenses = goal().count;
    return figures;
}

Goal Program::goal() const {
    return session_ ? goal_of(session_->loaded().level, session_->state()) : Goal{};
}

bool Program::can_save() const {
    return has_saves() && stage_ == Stage::Walk && session_ && !session_->state().has_ended;
}

bool Program::has_unsaved_progress() const {
    constexpr std::int64_t kNothing_ticks = 2 * kTicksPerSecond;  // is lost in so short a time
    return stage_ == Stage::Walk && session_ && !session_->state().has_ended &&
           session_->state().tick > saved_tick_ + kNothing_ticks;
}

void Program::try_with_files(const std::string& what, const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& error) {
        pages_.open_message(what, error.what());
    }
}

std::shared_ptr<const LoadedLevel> Program::loaded_as(const std::string& level) {
    LevelFiles files = level_files_;
    files.level = level;
    return std::make_shared<const LoadedLevel>(files);
}

void Program::walk() {
    if (const auto first = std::move(first_walk_))
        return start(std::move(first->loaded), std::move(first->input),
                     options_.replay.empty() ? Stage::Walk : Stage::Replay);
    try_with_files("Walk", [&] { start_walk(loaded_as("")); });
}

void Program::play_level(const std::string& file) {
    try_with_files("Levels", [&] { start_walk(loaded_as(file)); });
}

void Program::play_next() {
    const std::string next(next_map(session_->loaded().level, session_->state()));
    try_with_files("Levels", [&] { start_walk(loaded_as(find_named_level(next, places()))); });
}

void Program::restart() {
    start_walk(session_->shared_level());
}

void Program::show_gallery() {
    menu_.close_all();
    gallery_ = std::make_unique<Gallery>(session_->shared_level(), settings_, view_options_, platform_);
}

void Program::write_save(SaveSlot slot) {
    const LoadedLevel& loaded = session_->loaded();
    slots_.save(slot, {saved_level_of(loaded.data, loaded.level), session_->state(), session_->thumbnail()});
    saved_tick_ = session_->state().tick;
}

void Program::save_to(SaveSlot slot) {
    if (!can_save()) return session_->show("This game cannot be saved.");
    try_with_files("Save", [&] {
        write_save(slot);
        if (slot != SaveSlot::LevelStart) session_->show("Saved: " + name_of(slot));
    });
}

void Program::load_from(SaveSlot slot) {
    try_with_files("Load", [&] {
        const SlotContent content = slots_.load(slot);
        if (!content.game) {
            if (content.refusal.empty()) return session_->show(name_of(slot) + ": nothing is saved there");
            return pages_.open_message("Load", content.refusal);
        }
        const SavedGame& game = *content.game;
        const bool is_here = game.level.file_hash == session_->loaded().data.level_hash;
        auto loaded = is_here ? session_->shared_level() : loaded_as(level_file_of(game));
        naming_file(game.level.name, [&] { check_level(game, loaded->data.level_hash, loaded->level); });
        const GameState state = start_of(loaded->level);
        start(std::move(loaded), TickInputSource(state, std::nullopt, false), Stage::Walk);
        session_->restore(game.state);
        saved_tick_ = game.state.tick;
        session_->show("Loaded: " + name_of(slot));
        if (content.is_former) pages_.open_message("Load", "The one saved before it was loaded. " + content.refusal);
    });
}

std::string Program::save_on_leaving() {
    if (!can_save() || session_->state().tick <= saved_tick_) return "";
    try {
        write_save(SaveSlot::Automatic);
        return "";
    } catch (const FileError& error) {
        return error.what();
    }
}

void Program::leave_walk(const std::function<void()>& go) {
    const std::string fault = save_on_leaving();
    if (fault.empty()) return go();
    pages_.open_not_saved(fault, go);
}

void Program::show_title() {
    leave_walk([this] { try_with_files("Title", [this] { start_title(loaded_as("")); }); });
}

void Program::leave() {
    leave_walk([this] { has_left_ = true; });
}

void Program::keep_recorded() {
    if (session_ && session_->input().records() && !recorded_)
        recorded_ = std::make_unique<Demo>(session_->input().recorded());
}

std::string Program::credits() const {
    return "Oblong " OBLONG_VERSION
           "\n\nA world of 320x200 pixels in the right shape.\n\n"
           "The program: the MIT licence. Textures, models, palette, level, sounds and music of the museum were made "
           "for Oblong and may be used under CC0 1.0 or MIT.\n\n"
           "Levels and models of Quake belong to id Software, or to who made them; none comes with Oblong.\n\n"
           "It stands on SDL and SDL_mixer (zlib licence), libpng (libpng licence), zlib (zlib licence), CLI11 "
           "(BSD licence), JSON for Modern C++, tinyobjloader and stb (MIT licence).\n\n"
           "What it does was learnt from Casey Muratori, Michael Abrash and the texts that the README names.";
}

}  // namespace oblong

#include "game/program/screens.h"

#include <filesystem>

#include "engine/io/files.h"
#include "engine/programs/arguments.h"
#include "game/simulation/rooms.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

ViewOptions view_options_of(const Options& options) {
    ViewOptions view_options;
    view_options.preferences = options.preferences;
    view_options.log = options.log;
    view_options.map = options.automap;
    view_options.wireframe = options.wireframe;
    view_options.line_method = options.line_method;
    if (options.chooses_view) view_options.choice.begin(view_options.preferences);
    return view_options;
}

}  // namespace

Screens::Screens(const Options& options, ProgramFiles files, PreferencesStore& store, Platform& platform,
                 ProgramParts parts)
    : options_(options),
      game_(options_, *files.loaded),
      view_options_(view_options_of(options)),
      store_(store),
      platform_(platform),
      parts_(std::move(parts)),
      watch_(std::move(files.watch)),
      sound_(parts_.open_sound, files.loaded->files.assets, own_sounds_of(game_.definition())),
      saves_(saves_folder_of(options)),
      pages_(menu_, *this) {
    const bool names_walk = !(options_.replay + options_.record + options_.level + options_.map).empty();
    if (!options_.shows_gallery && (names_walk || !options_.shows_title))
        first_walk_ = std::make_unique<FirstWalk>(FirstWalk{files.loaded, std::move(files.input)});
    if (options_.shows_gallery)
        show_only(parts_.open_gallery(std::move(files.loaded), view_options_, platform_));
    else if (options_.shows_title)
        start_title(std::move(files.loaded));
    else
        walk();
    if (walk_ && !options_.room.empty()) begin_in_room();
}

void Screens::begin_in_room() {
    GameState state = walk_->state();
    enter_room(options_.room, walk_->loaded().level, state);
    walk_->restore(state);
    walk_->visit();
}

void Screens::follow() {
    saves_.autosave_when_due(&up() == walk_ && !menu_.is_open());
    follow_map();
    const Preferences& now = view_options_.preferences;
    sound_.set({now.volume_100, now.sounds_volume_100, now.music_volume_100, now.shows_captions});
    sound_.hold(!up().is_heard(menu_.is_open()));
}

void Screens::finish() {
    if (const Demo* const demo = recorded_demo()) write_file(options_.record, encode_demo(*demo));
}

void Screens::close_gallery() {
    screens_.pop_back();
    name_window();
    up().open_page(Action::Menu, pages_);
    up().advance_behind_menu(platform_.now_us());
}

void Screens::follow_map() {
    if (!watch_ || !walk_ || &up() != walk_) return;
    const std::uint64_t now_us = platform_.now_us();
    try {
        if (const auto result = watch_->poll(now_us)) {
            if (!result->has_level)
                print_fault("oblong", FileError(options_.watch, "oblong-map", result->fault).what());
            if (result->has_level) show_changed_level();
        }
    } catch (const FileError& error) {  // an editor may remove a file while it is read
        watch_->remind_of(error.what());
    }
    if (const std::string fault = watch_->due_reminder(now_us); !fault.empty()) walk_->show(fault);
}

// The player stays in place, and the walk keeps its number; all else is at the level's start.
void Screens::show_changed_level() {
    auto loaded = load_level(watch_->level_file());
    const bool is_tight = loaded->leak_path.empty();
    const Player player = walk_->state().player;
    saves_.finish_autosave();
    std::optional<HeldWalk> held = saves_.release();
    start_walk(std::move(loaded));
    GameState state = walk_->state();
    state.player = player;
    state.player.ground = Player::kNoGround;
    walk_->restore(state);
    saves_.begin(walk_, std::move(held));
    if (is_tight) walk_->show("The level as it is now");
}

// Frees the other screens and all that belongs to them.
void Screens::show_only(std::unique_ptr<GameScreen> screen) {
    saves_.begin(nullptr);
    walk_ = nullptr;
    screens_.clear();
    screens_.push_back(std::move(screen));
    has_changed_ = true;
}

// Ends the current walk.
void Screens::finish_walk(const LoadedLevel& next) {
    saves_.finish_autosave();
    keep_recorded();
    follow_game(next);
    sound_.enter(nullptr);  // before its level is freed
}

void Screens::start(std::shared_ptr<const LoadedLevel> loaded, TickInputSource input, SessionKind kind) {
    finish_walk(*loaded);
    const SessionSettings settings{parts_.workers, &sound_, kind, parts_.open_meter};
    auto walk = std::make_unique<Session>(std::move(loaded), settings, view_options_, std::move(input), platform_);
    Session* const session = walk.get();
    show_only(std::move(walk));
    walk_ = session;
    sound_.play_music(game_.music_of(walk_->loaded()));
    sound_.enter(&walk_->loaded().level, &walk_->loaded().data.sounds);
    saves_.begin(kind == SessionKind::Walk ? walk_ : nullptr);
    name_window();
}

// A damaged demo is found before the current walk ends.
void Screens::start_title(std::shared_ptr<const LoadedLevel> loaded) {
    auto title = std::make_unique<Title>(loaded, game_.definition().demo, parts_.workers, view_options_, platform_);
    finish_walk(*loaded);
    show_only(std::move(title));
    sound_.play_music(game_.definition().music);
    name_window();
    last_walk_ = saves_.is_kept() ? saves_.slots().last_walk() : std::nullopt;
    pages_.open_title();
}

// Each game has its own light. Headless frames have the museum's.
void Screens::follow_game(const LoadedLevel& loaded) {
    if (options_.headless_frames > 0) return;
    Preferences& now = view_options_.preferences;
    const bool is_museum = game_.is_museum(loaded.data.palette);
    now.game = is_museum ? kMuseum : game_name(options_.game);
    if (is_first_game_ && !is_museum) {
        now.lights = store_.kept().lights;
        for (const auto& [name, text] : options_.light) preference_named(name).parse(now, text);
        store_.begin_with(now);
    }
    is_first_game_ = false;
}

void Screens::name_window() {
    const fs::path level = level_below().data.level_file;
    platform_.set_title((game_.definition().title + " - " + level.stem().string()).c_str());
}

void Screens::start_walk(std::shared_ptr<const LoadedLevel> loaded) {
    const GameState state = start_of(loaded->level);
    start(std::move(loaded), TickInputSource(state, std::nullopt, false), SessionKind::Walk);
}

EndFigures Screens::end_figures() const {
    GameState end = walk_->state();
    end.tick -= walk_->ticks_since_end();
    EndFigures figures = game_.end_figures(walk_->loaded(), end);
    figures.picture = walk_->figures();
    return figures;
}

void Screens::try_with_files(const std::string& what, const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& error) {
        pages_.open_message(what, error.what());
    }
}

std::shared_ptr<const LoadedLevel> Screens::load_level(const std::string& file) const {
    return game_.load(file, screens_.front()->shared_level());
}

void Screens::walk() {
    if (const auto first = std::move(first_walk_))
        return start(std::move(first->loaded), std::move(first->input),
                     options_.replay.empty() ? SessionKind::Walk : SessionKind::Replay);
    try_with_files("Walk", [&] { start_walk(load_level("")); });
}

void Screens::visit() {
    walk();
    if (walk_) walk_->visit();
}

void Screens::play_level(const std::string& file) {
    try_with_files("Levels", [&] { leave_walk([this, loaded = load_level(file)] { start_walk(loaded); }); });
}

void Screens::play_next() {
    try_with_files("Levels", [&] { start_walk(load_level(game_.next_file(walk_->loaded(), walk_->state()))); });
}

void Screens::restart() {
    leave_walk([this] { start_walk(walk_->shared_level()); });
}

void Screens::show_gallery() {
    try_with_files("Gallery", [&] {
        if (!parts_.open_gallery) return parts_.start_gallery();
        auto gallery = parts_.open_gallery(game_.museum(up().shared_level()), view_options_, platform_);
        menu_.close_all();
        screens_.push_back(std::move(gallery));
    });
}

void Screens::show_title() {
    leave_walk([this] { try_with_files("Title", [this] { start_title(load_level("")); }); });
}

// The demo is written before: a player whose disk is full may make room while the game is on.
void Screens::leave() {
    leave_walk([this] {
        const auto go = [this] { has_left_ = true; };
        try {
            finish();
            go();
        } catch (const FileError& error) {
            pages_.open_not_saved(error.what(), go);
        }
    });
}

const Demo* Screens::recorded_demo() const {
    if (recorded_) return recorded_.get();
    return walk_ && walk_->input().records() ? &walk_->input().recorded() : nullptr;
}

void Screens::keep_recorded() {
    if (recorded_) return;
    if (const Demo* const demo = recorded_demo()) recorded_ = std::make_unique<Demo>(*demo);
}

}  // namespace oblong

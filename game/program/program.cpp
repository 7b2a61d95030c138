#include "game/program/program.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "engine/files/arguments.h"
#include "engine/files/files.h"
#include "game/program/own_files.h"
#include "game/view/screenshot.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

constexpr std::int32_t kLongestWait_ms = 500;

ViewOptions view_options_of(const Options& options) {
    ViewOptions view_options;
    view_options.preferences = options.preferences;
    view_options.log = options.log;
    view_options.map = options.automap;
    view_options.wireframe = options.wireframe;
    view_options.line_method = options.line_method;
    return view_options;
}

bool is_input(const Controls& controls) {
    const bool is_pointed = controls.pointer && (controls.pointer->has_moved || controls.pointer->is_pressed);
    return is_pointed || controls.pressed || !controls.menu.empty() || !controls.commands.empty();
}

std::optional<Sound> sound_of(MenuEvent event) {
    switch (event) {
        case MenuEvent::None:
            return {};
        case MenuEvent::Moved:
        case MenuEvent::Changed:
            return Sound::MenuMove;
        case MenuEvent::Accepted:
            return Sound::MenuAccept;
        case MenuEvent::WentBack:
            return Sound::MenuBack;
    }
    return {};
}

}  // namespace

Program::Program(const Options& options, ProgramFiles files, PreferencesStore& store, Platform& platform,
                 Workers* workers, OpenSound open_sound)
    : options_(options),
      game_(options_, files.assets_folder, *files.loaded),
      view_options_(view_options_of(options)),
      store_(store),
      platform_(platform),
      settings_{workers},
      watch_(std::move(files.watch)),
      sound_(std::move(open_sound), files.assets_folder, own_sounds_of(game_.definition())),
      saves_(saves_folder_of(options)),
      input_(view_options_.preferences.bindings),
      pages_(menu_, *this) {
    show_icon(game_.definition(), platform_);
    if (options_.shows_gallery)
        show_only(std::make_unique<Gallery>(std::move(files.loaded), settings_, view_options_, platform_));
    else if (options_.shows_title) {
        if (!(options_.replay + options_.record).empty())
            first_walk_ = std::make_unique<FirstWalk>(FirstWalk{files.loaded, std::move(files.input)});
        start_title(std::move(files.loaded));
    } else
        start(std::move(files.loaded), std::move(files.input),
              options_.replay.empty() ? SessionKind::Walk : SessionKind::Replay);
}

void Program::run() {
    while (step()) {
    }
}

bool Program::step() {
    const bool goes_on = platform_.is_open() && !has_left_;
    goes_on ? naming_file(options_.replay, [&] { show_frame(); }) : finish();
    return goes_on;
}

void Program::keep() {
    print_fault("oblong", saves_.save_on_leaving());
    print_fault("oblong", store_.save(view_options_.preferences));
}

void Program::finish() {
    keep();
    keep_recorded();
    if (recorded_) write_file(options_.record, encode_demo(*recorded_));
}

void Program::show_frame() {
    const Controls controls = input_.take(platform_.poll(), platform_.now_us() / 1000);
    const std::size_t depth = menu_.depth();
    take(controls);
    if (has_left_) return;
    saves_.autosave_when_due(&screen() == walk_ && !menu_.is_open());
    is_stale_ |= menu_.depth() != depth;  // a page may open by itself: at the end, without the focus
    follow_preferences();
    follow_map();
    const WindowSize size = platform_.window_size();
    is_stale_ |= is_moving() || is_input(controls) || size != shown_size_;
    if (is_stale_ && !controls.is_minimised) {
        shown_size_ = size;
        is_stale_ = false;
        return draw();
    }
    is_stale_ |= platform_.wait_for_input(std::min(kLongestWait_ms, input_.longest_wait_ms()));
}

void Program::take(const Controls& controls) {
    if (controls.changes_full_screen) preferences().fills_screen = !preferences().fills_screen;
    if (controls.pressed) view_options_.uses_pad = is_of_pad(*controls.pressed);
    const bool is_left =
        (std::exchange(had_focus_, controls.has_focus) && !controls.has_focus) || controls.is_minimised;
    if (is_left && screen().captures_mouse() && !menu_.is_open()) screen().open_page(Action::Menu, pages_);
    if (menu_.is_open())
        take_in_menu(controls);
    else
        take_on_screen(controls);
    // The title and a walk that has ended are never without a page.
    if (!menu_.is_open() && !has_left_) screen().open_due_page(pages_);
    const bool is_captured = screen().captures_mouse() && !menu_.is_open();
    if (std::exchange(is_mouse_captured_, is_captured) != is_captured) platform_.capture_mouse(is_captured);
}

void Program::take_in_menu(const Controls& controls) {
    const Preferences& now = view_options_.preferences;
    const CanvasSize canvas{now.mode.width_px, now.mode.height_px};
    const std::size_t depth = menu_.depth();
    wants_screenshot_ |= controls.has(Action::Screenshot) && !menu_.page().press;
    const MenuEvent event = menu_.handle(controls, canvas, now.text_scale, shown_rect(now, platform_.window_size()));
    if (const auto sound = sound_of(event)) sound_.play(*sound);
    if (menu_.depth() < depth) print_fault("oblong", store_.save(now));
    screen().advance_behind_menu(platform_.now_us());
}

void Program::take_on_screen(const Controls& controls) {
    if (controls.has(Action::Menu) && screens_.size() > 1) return close_gallery();
    for (const Action command : {Action::Menu, Action::ShowHelp, Action::FrameCost})
        if (!menu_.is_open() && controls.has(command)) screen().open_page(command, pages_);
    if (menu_.is_open()) return screen().advance_behind_menu(platform_.now_us());
    const auto is_walking = [this] { return &screen() == walk_ && walk_->kind() == SessionKind::Walk; };
    if (is_walking() && controls.has(Action::QuickLoad)) quick_load();
    if (is_walking() && controls.has(Action::Restart)) screen().open_page(Action::Restart, pages_);
    screen().advance(controls, platform_.now_us());
    // After the ticks: the picture that is saved is the one that is shown next, drawn once.
    if (is_walking() && controls.has(Action::QuickSave)) quick_save();
}

// Back to what it was opened from.
void Program::close_gallery() {
    screens_.pop_back();
    name_window();
    screen().open_page(Action::Menu, pages_);
    screen().advance_behind_menu(platform_.now_us());
}

void Program::follow_preferences() {
    platform_.change_window(window_settings_of(view_options_.preferences));
    print_fault("oblong", store_.save_when_settled(view_options_.preferences, platform_.now_us()));
    follow_sound();
}

void Program::follow_map() {
    if (!watch_ || !walk_) return;
    const std::uint64_t now_us = platform_.now_us();
    if (const auto news = watch_->poll(now_us)) {
        print_fault("oblong", news->fault);
        if (news->has_level) show_changed_level();
        walk_->show_path(news->leak_path);
    }
    if (const std::string fault = watch_->due_reminder(now_us); !fault.empty()) walk_->show(fault);
}

// The player stays in place; all else is as the level begins.
void Program::show_changed_level() {
    try {
        const Player player = walk_->state().player;
        start_walk(load_level(watch_->level_file()));
        GameState state = walk_->state();
        state.player = player;
        state.player.ground = Player::kNoGround;
        walk_->restore(state);
        walk_->show("The level as it is now");
    } catch (const FileError& error) {
        watch_->remind_of(error.what());
    }
}

void Program::follow_sound() {
    const Preferences& now = view_options_.preferences;
    sound_.set({now.volume_100, now.sounds_volume_100, now.music_volume_100, now.shows_captions});
    sound_.hold(!screen().is_heard(menu_.is_open()));
}

bool Program::is_moving() const {
    return !menu_.is_open() || screens_.back()->moves_behind_menu();
}

void Program::draw() {
    const ShownPicture picture = screen().draw(menu_.is_open());
    if (menu_.is_open()) draw_menu(picture);
    platform_.present(picture.canvas, picture.palette, picture.rect);
}

void Program::draw_menu(const ShownPicture& picture) {
    const Preferences& now = view_options_.preferences;
    menu_.draw(now.text_scale, screen().menu_look(), picture.palette, picture.canvas);
    if (!std::exchange(wants_screenshot_, false)) return;
    pages_.open_message("Screenshot", key_names().in(save_screenshots(settings_.screenshot_folder, picture.canvas,
                                                                      picture.palette, now.mode)));
    is_stale_ = true;
}

// What was up goes with all that belongs to it.
void Program::show_only(std::unique_ptr<GameScreen> screen) {
    saves_.begin(nullptr);
    walk_ = nullptr;
    screens_.clear();
    screens_.push_back(std::move(screen));
    is_stale_ = true;
}

// The walk that was on ends.
void Program::finish_walk(const LoadedLevel& next) {
    saves_.finish_autosave();
    keep_recorded();
    follow_game(next);
    sound_.enter(nullptr);  // before the level that is heard goes
}

void Program::start(std::shared_ptr<const LoadedLevel> loaded, TickInputSource input, SessionKind kind) {
    finish_walk(*loaded);
    SessionSettings settings = settings_;
    settings.kind = kind;
    settings.sound = &sound_;
    auto walk = std::make_unique<Session>(std::move(loaded), settings, view_options_, std::move(input), platform_);
    Session* const session = walk.get();
    show_only(std::move(walk));
    walk_ = session;
    play_level_music();
    sound_.enter(&walk_->loaded().level, &walk_->loaded().data.sounds);
    saves_.begin(kind == SessionKind::Walk ? walk_ : nullptr);
    name_window();
}

void Program::start_title(std::shared_ptr<const LoadedLevel> loaded) {
    finish_walk(*loaded);
    show_only(std::make_unique<Title>(std::move(loaded), game_.definition().demo, settings_, view_options_, platform_));
    sound_.play_music(game_.definition().music);
    name_window();
    last_walk_ = saves_.is_kept() ? saves_.slots().last_walk() : std::nullopt;
    pages_.open_title();
    if (!options_.folders.config_file.empty() && !view_options_.preferences.has_set_light) pages_.open_light();
}

// Light is kept a game. Frames that are written are shown by nobody's taste: as the museum's.
void Program::follow_game(const LoadedLevel& loaded) {
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

void Program::play_level_music() {
    const LevelMusic music = game_.music_of(walk_->loaded());
    sound_.play_music(music.file);
    print_fault("oblong", music.fault);
}

void Program::name_window() {
    const fs::path level = level_below().data.level_file;
    platform_.set_title((game_.definition().title + " - " + level.stem().string()).c_str());
}

void Program::start_walk(std::shared_ptr<const LoadedLevel> loaded) {
    const GameState state = start_of(loaded->level);
    start(std::move(loaded), TickInputSource(state, std::nullopt, false), SessionKind::Walk);
}

}  // namespace oblong

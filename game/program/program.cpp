#include "game/program/program.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "engine/base/table.h"
#include "engine/io/files.h"
#include "engine/pictures/picture.h"
#include "engine/platform/headless.h"
#include "engine/programs/arguments.h"
#include "engine/view/screen.h"
#include "game/input/bindings.h"
#include "game/simulation/tick.h"
#include "game/view/screenshot.h"

namespace oblong {
namespace {

constexpr std::int32_t kLongestWait_ms = 500;

bool is_input(const Controls& controls) {
    const bool is_pointed = controls.pointer && (controls.pointer->has_moved || controls.pointer->is_pressed);
    return is_pointed || controls.pressed || !controls.menu.empty() || !controls.commands.empty();
}

constexpr std::array<std::optional<Sound>, 5> kMenuSounds{std::nullopt, Sound::MenuMove, Sound::MenuMove,
                                                          Sound::MenuAccept, Sound::MenuBack};  // by MenuEvent

namespace fs = std::filesystem;

// Writes 00000.png, 00001.png and so on into a folder.
HeadlessPlatform::FrameSink png_sink(const std::string& folder) {
    make_folder(folder);
    return [folder, frame = 0](Framebuffer picture, const Palette& palette) mutable {
        char name[16];
        std::snprintf(name, sizeof name, "%05d.png", frame++);
        const std::size_t size = pixel_count(picture.width_px, picture.height_px);
        write_file((fs::path(folder) / name).string(),
                   encode_indexed_png({picture.pixels, size}, picture.width_px, picture.height_px, palette));
    };
}

void hold(Action action, bool is_held, PlatformInput& input) {
    input.events.push_back({is_held ? InputEvent::Kind::Press : InputEvent::Kind::Release, scripted(action), 0, 0});
}

// The input of --headless without a demo, in ticks: 2.5 s ahead, a quarter turn to the right, 4 s ahead with a jump, a
// turn to the left.
PlatformInput short_walk(std::int64_t tick) {
    constexpr std::int64_t kTurn = 87, kAhead = 110, kJump = 130, kLook = 250, kRound = 280;
    const std::int64_t at = tick % kRound;
    PlatformInput input;
    hold(Action::Forward, at < kTurn || (at >= kAhead && at < kLook), input);
    hold(Action::TurnRight, at >= kTurn && at < kAhead, input);
    hold(Action::TurnLeft, at >= kLook, input);
    hold(Action::Jump, at == kJump, input);
    return input;
}

// The input of --headless --gallery: a row a picture.
PlatformInput page_through(std::int64_t poll) {
    PlatformInput input;
    if (poll > 0)
        for (const bool is_held : {true, false}) hold(Action::PageDown, is_held, input);
    return input;
}

}  // namespace

Program::Program(const Options& options, ProgramFiles files, PreferencesStore& store, Platform& platform,
                 ProgramParts parts)
    : replayed_(options.replay),
      store_(store),
      platform_(platform),
      screens_(options, std::move(files), store, platform, std::move(parts)),
      input_(preferences().bindings) {
    if (!options.folders.fault.empty()) screens_.pages().open_message("Saves", options.folders.fault);
}

void Program::run() {
    while (step()) {
    }
}

bool Program::step() {
    if (platform_.is_open() && !screens_.has_left()) {
        naming_file(replayed_, [&] { show_frame(); });
        return true;
    }
    keep();
    screens_.finish();
    return false;
}

void Program::keep() {
    print_fault("oblong", screens_.keep());
    tell_of(store_.save(preferences()));
}

void Program::show_frame() {
    Controls controls = input_.take(platform_.poll(), platform_.now_us() / 1000);
    if (const std::optional<Action> asked = screens_.take_asked()) controls.commands.push_back(*asked);
    const std::size_t depth = screens_.menu().depth();
    take(controls);
    if (screens_.has_left()) return;
    is_stale_ |= screens_.menu().depth() != depth;  // a page may open by itself: at the end, or when the focus is lost
    platform_.change_window(window_settings_of(preferences()));
    tell_of(store_.save_when_settled(preferences(), platform_.now_us()));
    screens_.follow();
    const WindowSize size = platform_.window_size();
    is_stale_ |= screens_.take_has_changed() || is_moving() || is_input(controls) || size != shown_size_;
    const std::int32_t left_ms = shown_for_ms();
    if (is_stale_ && !controls.is_minimised && left_ms == 0) {
        shown_size_ = size;
        is_stale_ = false;
        return draw();
    }
    if (left_ms > 0 && !controls.is_minimised)
        if (const std::optional<ShownPicture> recoloured = screens_.up().recoloured()) present(*recoloured);
    const std::int32_t longest_ms = std::min(kLongestWait_ms, input_.longest_wait_ms());
    is_stale_ |= platform_.wait_for_input(left_ms == 0 ? longest_ms : std::min(left_ms, longest_ms));
}

// How long the picture of a slower machine still stays, at most a tick: the game goes on meanwhile. A menu is not its
// work.
std::int32_t Program::shown_for_ms() {
    const std::uint64_t until_us = screens_.up().shows_until_us(), now_us = platform_.now_us();
    if (screens_.menu().is_open() || until_us <= now_us) return 0;
    return static_cast<std::int32_t>(std::min<std::uint64_t>((until_us - now_us + 999) / 1000, 1000 / kTicksPerSecond));
}

void Program::take(const Controls& controls) {
    ViewOptions& view_options = screens_.view_options();
    if (controls.changes_full_screen) view_options.preferences.fills_screen = !preferences().fills_screen;
    if (controls.pressed) view_options.uses_pad = is_of_pad(*controls.pressed);
    const bool is_left =
        (std::exchange(had_focus_, controls.has_focus) && !controls.has_focus) || controls.is_minimised;
    const Menu& menu = screens_.menu();
    if (is_left && screens_.up().captures_mouse() && !menu.is_open())
        screens_.up().open_page(Action::Menu, screens_.pages());
    if (menu.is_open())
        take_in_menu(controls);
    else
        take_on_screen(controls);
    // The title and an ended walk always show a page.
    if (!menu.is_open() && !screens_.has_left()) screens_.up().open_due_page(screens_.pages());
    const bool is_captured = screens_.up().captures_mouse() && !menu.is_open();
    if (std::exchange(is_mouse_captured_, is_captured) != is_captured) platform_.capture_mouse(is_captured);
}

void Program::take_in_menu(const Controls& controls) {
    const Preferences& now = preferences();
    Menu& menu = screens_.menu();
    const WindowSize window = platform_.window_size();
    const ScreenMode mode = picture_in(window, now).mode;
    const CanvasSize canvas{mode.width_px, mode.height_px};
    const std::size_t depth = menu.depth();
    wants_screenshot_ |= controls.has(Action::Screenshot) && !menu.page().press;
    const MenuEvent event = menu.handle(controls, canvas, now.text_scale, shown_rect(now, window));
    if (const auto sound = item(kMenuSounds, event)) screens_.play(*sound);
    if (menu.depth() < depth) tell_in_menu(store_.save(now));
    screens_.up().advance_behind_menu(platform_.now_us());
}

void Program::tell_of(const std::string& unsaved) {
    if (!unsaved.empty() && !std::exchange(has_told_, true)) print_fault("oblong", unsaved);
}

// A player who started the game from a desktop does not see standard error.
void Program::tell_in_menu(const std::string& unsaved) {
    tell_of(unsaved);
    if (!unsaved.empty() && !std::exchange(has_told_in_menu_, true))
        screens_.pages().open_message("Options", "Changes are not kept: " + unsaved);
}

void Program::take_on_screen(const Controls& controls) {
    if (controls.has(Action::Menu) && screens_.is_gallery_over_another()) return screens_.close_gallery();
    for (const Action command : {Action::Menu, Action::ShowHelp, Action::FrameCost})
        if (!screens_.menu().is_open() && controls.has(command)) screens_.up().open_page(command, screens_.pages());
    if (screens_.menu().is_open()) return screens_.up().advance_behind_menu(platform_.now_us());
    if (screens_.is_in_level() && controls.has(Action::QuickLoad)) screens_.quick_load();
    if (screens_.is_walking() && controls.has(Action::Restart))
        screens_.up().open_page(Action::Restart, screens_.pages());
    screens_.up().advance(controls, platform_.now_us());
    // After the ticks, so that the saved picture is the one shown next, and is drawn once.
    if (screens_.is_in_level() && controls.has(Action::QuickSave)) screens_.quick_save();
}

void Program::draw() {
    const bool is_menu_open = screens_.menu().is_open();
    const ShownPicture picture = screens_.up().draw(is_menu_open);
    if (is_menu_open) draw_menu(picture);
    present(picture);
}

void Program::draw_menu(const ShownPicture& picture) {
    const Preferences& now = preferences();
    screens_.menu().draw(now.text_scale, screens_.up().menu_look(), picture.palette, picture.canvas);
    if (!std::exchange(wants_screenshot_, false)) return;
    const std::string saved =
        save_screenshots(picture.canvas, picture.palette, picture_in(platform_.window_size(), now).mode);
    screens_.pages().open_message("Screenshot", screens_.key_names().in(saved));
    is_stale_ = true;
}

std::unique_ptr<Platform> open_headless(const Options& options) {
    const auto script = [&options](std::int64_t poll) {
        if (options.shows_gallery) return page_through(poll);
        return options.replay.empty() ? short_walk(poll) : PlatformInput{};
    };
    return std::make_unique<HeadlessPlatform>(options.headless_frames, kTicksPerSecond, script, png_sink(options.out));
}

}  // namespace oblong

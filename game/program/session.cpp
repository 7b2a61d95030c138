#include "game/program/session.h"

#include <new>
#include <utility>

#include "engine/programs/arguments.h"
#include "game/lab/lab.h"
#include "game/lab/lab_measures.h"
#include "game/lab/lab_options.h"
#include "game/simulation/items.h"
#include "game/view/screenshot.h"

namespace oblong {
namespace {

// The part of a picture that has a thumbnail's shape: of one that is narrower, the rows in the middle.
Framebuffer thumbnail_part(Framebuffer picture, const ScreenMode& mode) {
    const Ratio part = mode.display * Ratio{3, 4};
    const std::int64_t rows = std::min<std::int64_t>(
        picture.height_px, std::max<std::int64_t>(1, picture.height_px * part.numerator / part.denominator));
    const auto height_px = static_cast<std::int32_t>(rows);
    return part_of(picture, {0, (picture.height_px - height_px) / 2, picture.width_px, height_px});
}

}  // namespace

Session::Session(std::shared_ptr<const LoadedLevel> loaded, const SessionSettings& settings, ViewOptions& view_options,
                 TickInputSource input, Platform& platform)
    : loaded_(std::move(loaded)),
      platform_(platform),
      view_options_(view_options),
      settings_(settings),
      input_(std::move(input)),
      before_(start_of(loaded_->level)),
      after_(before_),
      palette_(loaded_->data),
      overlays_(*loaded_, view_options, settings.kind == SessionKind::Title ? no_overlays_ : view_options, platform,
                settings.open_meter),
      menu_look_(loaded_->data.palette),
      last_us_(platform.now_us()) {
    show(loaded_->leak_path.empty() ? "{help}: keys" : "The level leaks: the line leads out of it");
}

void Session::advance(const Controls& controls, std::uint64_t now_us) {
    const std::uint64_t elapsed_us = now_us - last_us_;
    last_us_ = now_us;
    has_drawn_ = false;
    played_us_ += elapsed_us;
    handle_commands(controls);
    Controls held = controls;
    if (!overlays_.on().lab.shows_panel) held.moves |= held.panel_moves;
    overlays_.drag(held);
    input_.use(view_options_.preferences);
    input_.gather(held);
    input_.note_view(view_dials_of(view_options_), work_);
    for (int due = clock_.advance(elapsed_us, view_options_.preferences.game_speed_100); due > 0; --due) {
        before_ = after_;
        const TickReport report = input_.play_tick(loaded_->level, after_);
        note_tick(report, due == 1);
        follow_demo();
    }
}

// A replay shows what its player saw; a title's, what this one chose.
void Session::follow_demo() {
    const ViewDials* const replayed = input_.replayed_view();
    if (settings_.kind == SessionKind::Replay && replayed)
        follow_view(std::exchange(replayed_view_, *replayed), *replayed, view_options_);
}

bool Session::captures_mouse() const {
    return settings_.kind == SessionKind::Walk || (settings_.kind == SessionKind::Replay && !input().is_replaying());
}

void Session::open_page(Action command, MenuPages& pages) {
    if (command == Action::Menu) state().has_ended ? pages.open_end() : pages.open_game();
    if (command == Action::ShowHelp) pages.open_keys();
    if (command == Action::Restart && settings_.kind == SessionKind::Walk) pages.open_restart();
}

// An ended walk shows a page, after the level's intermission.
void Session::open_due_page(MenuPages& menu) {
    if (!pages_.empty()) return menu.open_pages(std::exchange(pages_, {}));
    if (state().has_ended && ticks_since_end() >= intermission_ticks() && !input().is_replaying()) menu.open_end();
}

// The second half of an intermission is a 386's.
std::optional<Processor> Session::machine() const {
    const std::int64_t ticks = ticks_since_end(), all = intermission_ticks();
    return ticks * 2 >= all && ticks < all ? Processor::I386 : view_options_.preferences.machine;
}

std::vector<KeyHelp> Session::key_help(const KeyNames& names) const {
    std::vector<KeyHelp> help = game_help(names);
    if (!has_lab()) std::erase_if(help, [](const KeyHelp& line) { return is_of_lab(line.actions.front()); });
    return help;
}

void Session::handle_commands(const Controls& controls) {
    for (const Action command : controls.commands) {
        if (is_of_lab(command) && !has_lab()) continue;
        wants_screenshot_ |= command == Action::Screenshot;
        const std::string message =
            command == Action::Exhibit ? turn_exhibit() : apply(command, view_options_, platform_.window_size());
        if (!message.empty()) show(command == Action::Automap ? message + map_key() : message);
    }
}

// A place that asks for no dial gives back the usual picture.
std::string Session::turn_exhibit() {
    constexpr std::array kActions{Action::AccuracyTier, Action::ProjectionAspect, Action::DisplayAspect,
                                  Action::Isometric,    Action::Wireframe,        Action::ZoomOut};
    std::optional<ViewDialKind> dial = asked_dial(loaded_->level, state());
    if (!dial && asks_for_work(loaded_->level, state())) dial = ViewDialKind::Accuracy;
    if (dial) return apply(item(kActions, *dial), view_options_, platform_.window_size());
    follow_view(view_dials_of(view_options_), kUsualView, view_options_);
    return "{exhibit}: the usual picture. At an exhibit it turns a dial";
}

std::string Session::map_key() const {
    const bool has_diamonds = view_options_.map != MapView::Off && !last_lenses(loaded_->level, state()).empty();
    return has_diamonds ? ". Diamonds: " + loaded_->level.word_for_lenses + "; small: on the way" : "";
}

void Session::note_tick(const TickReport& report, bool is_last) {
    warn_of(report);
    palette_.note_tick(before_, after_);
    if (after_.has_ended && !before_.has_ended) ended_tick_ = after_.tick;
    if (settings_.sound) settings_.sound->note_tick(before_, after_, report, is_last);
    const std::string message = message_of(loaded_->level, before_, after_);
    if (!message.empty()) show(message);
    if (input().replayed_view()) return;  // who watches a demo keeps the machine of his own
    const std::string machine = pulled_machine(loaded_->level, before_, after_);
    if (!machine.empty()) show(choose_machine(machine, view_options_.preferences));
}

// Warns once of each kind.
void Session::warn_of(const TickReport& report) {
    for (const std::string_view left : report.left())
        if (warned_of_.insert(left).second)
            print_warnings("oblong", loaded_->data.level_file,
                           {"more happens at once than a tick may do: " + std::string(left)});
}

// A renderer is for one mode and size. The lab compares whole pictures.
void Session::follow_mode() {
    const PicturePreferences picture = picture_in(platform_.window_size(), view_options_.preferences);
    const ViewSize size = needs_lab(overlays_.on().lab) ? ViewSize{} : drawable_size(picture);
    if (renderer_ && renderer_->picture_mode() == picture.mode && renderer_->size() == size) return;
    renderer_.reset();  // before the next one needs its memory
    renderer_ = std::make_unique<GameRenderer>(loaded_->data, loaded_->level, picture.mode, settings_.workers, size);
}

GameView Session::shown_view() const {
    const InterpolatedState state = shown();
    const Preferences& preferences = view_options_.preferences;
    const PicturePreferences picture = picture_in(platform_.window_size(), preferences);
    Camera camera = camera_at(state, input_.look_offset(state.fraction_16), picture.field_of_view);
    if (preferences.view_bob_100 != 0 || preferences.view_roll_100 != 0) sway(state, preferences, camera);
    if (state.after.exit >= 0 && loaded_->level.intermission)
        show_intermission(*loaded_->level.intermission, ticks_since_end(), camera);
    const Overlays& on = overlays_.on();
    return {state, camera, on.has_torch,
            other_view(on.is_isometric, on.zoom_degrees, camera, renderer_->mode(), loaded_->data.level)};
}

Palette Session::palette_of(const InterpolatedState& state, const PaletteEffects& effects) const {
    const Palette& plain = loaded_->data.palette;
    return effects.is_plain() ? plain : apply_palette_effects(plain, effects, time_ms_at(state));
}

// What is shown over the picture may need more memory than there is: under DOS the lab does, beside sounds.
ShownPicture Session::draw(bool is_behind_menu) {
    try {
        return draw_all(is_behind_menu);
    } catch (const std::bad_alloc&) {
        if (!overlays_.close_largest()) throw;
        renderer_.reset();  // which the unfinished picture has left in any state
        show("Not enough memory for that, so it is off again");
        return draw_all(is_behind_menu);
    }
}

ShownPicture Session::draw_all(bool is_behind_menu) {
    follow_mode();
    overlays_.follow(last_us_);
    const Preferences& preferences = view_options_.preferences;
    const GameView view = shown_view();
    const Settings settings = settings_of(preferences), drawn = overlays_.shown(settings, last_us_);
    if (!std::exchange(has_drawn_, false) || overlays_.changes_picture()) draw_picture(view, drawn);
    PaletteEffects& effects = shown_effects_ =
        palette_.effects_at(view, preferences.flashes, preferences.light(), preferences.has_dac6);
    if (is_behind_menu) effects.flash = {};  // it would brighten the menu
    overlays_.note(view, drawn, effects, last_us_, *renderer_);

    const Framebuffer canvas = renderer_->canvas();
    if (!is_behind_menu) overlays_.draw_lab_pictures(view, settings, last_us_, canvas);
    overlays_.draw_lines(view, drawn, *renderer_);
    PanelText panels;
    if (!is_behind_menu) panels = overlays_.draw_panels(view, settings, last_us_, canvas);
    const bool has_counts = loaded_->files.game && loaded_->files.game->has_counts;
    if (std::string status = status_text(loaded_->level, state(), has_counts); !status.empty())
        panels.notes.push_back(std::move(status));
    if (const auto shown = machine()) panels.notes.push_back(describe_rate(*shown, cycles_));
    const Palette& palette = shown_colours_ = palette_of(view.state, effects);
    if (std::exchange(wants_screenshot_, false)) show(save_screenshots(canvas, palette, renderer_->picture_mode()));
    if (!is_behind_menu)
        overlays_.draw_text(std::move(panels),
                            settings_.sound ? settings_.sound->captions() : std::vector<std::string>(), messages_,
                            played_us_, menu_look_.veil, canvas);
    return {canvas, palette, shown_rect(preferences, platform_.window_size())};
}

// Not of a picture that thumbnail() has drawn, which is without text.
std::optional<ShownPicture> Session::recoloured() {
    if (!renderer_ || has_drawn_) return std::nullopt;
    const Palette now = palette_of(shown(), shown_effects_);
    if (now.colours == shown_colours_.colours) return std::nullopt;
    shown_colours_ = now;
    return ShownPicture{renderer_->canvas(), now, shown_rect(view_options_.preferences, platform_.window_size())};
}

// Counts what it draws if the player or the level asks for its time.
void Session::draw_picture(const GameView& view, const Settings& drawn) {
    shows_until_us_ = last_us_;
    const std::optional<Processor> paced_as = machine();
    const bool counts_work = asks_for_work(loaded_->level, state());
    work_ = 0;
    if (!paced_as && !counts_work) {
        const std::uint64_t began_us = platform_.now_us();
        renderer_->draw(view, drawn);
        if (view_options_.choice.is_on())
            view_options_.choice.note(platform_.now_us() - began_us, view_options_.preferences);
        return;
    }
    const Events events = events_of(renderer_->draw_and_count(view, drawn), drawn.accuracy);
    if (counts_work)
        work_ =
            static_cast<std::uint16_t>(std::clamp<std::int64_t>(cycles_on(Processor::I486, events) / 1000, 1, 0xffff));
    if (!paced_as) return;
    cycles_ = cycles_on(*paced_as, events);
    shows_until_us_ += static_cast<std::uint64_t>(cycles_ / megahertz_of(*paced_as));
}

std::string Session::figures() const {
    if (!renderer_) return "";
    const GameView view = shown_view();
    const Settings settings = settings_of(view_options_.preferences);
    const Events events = events_of(renderer_->draw_and_count(view, settings), settings.accuracy);
    const auto meter = open_meter_of(settings_.open_meter, loaded_->data.level_file, loaded_->level);
    const ErrorSummary errors = summarize_pixels(meter->measure(view, settings, *renderer_));
    return "Picture (" + setting_name(settings.accuracy) +
           "): " + describe_rate(Processor::I486, cycles_on(Processor::I486, events)) +
           (errors.count > 0 ? "\nIts worst texel: " + three_digits(errors.max) + " pixels off" : "");
}

std::string Session::save_picture(const std::string& text) {
    const ShownPicture picture = draw(true);
    Messages none;
    overlays_.draw_text({{text}, picture.canvas.height_px - kTextMargin_px}, {}, none, played_us_, menu_look_.veil,
                        picture.canvas);
    return save_screenshots(picture.canvas, picture.palette, renderer_->picture_mode());
}

Thumbnail Session::thumbnail() {
    follow_mode();
    const GameView view = shown_view();
    const Preferences& preferences = view_options_.preferences;
    renderer_->draw(view, settings_of(preferences));
    has_drawn_ = true;
    const PaletteEffects effects =
        palette_.effects_at(view, preferences.flashes, preferences.light(), preferences.has_dac6);
    return make_thumbnail(thumbnail_part(renderer_->shown(), renderer_->mode()), palette_of(view.state, effects));
}

void Session::restore(const GameState& state) {
    before_ = after_ = state;
    ended_tick_ = state.tick;
    has_drawn_ = false;
}

// Who watches a demo is not asked to turn pages.
void Session::show(const std::string& message) {
    std::string text = view_options_.key_names(platform_).in(message);
    const bool has_pages = text.find(kNewPage) != std::string::npos && !input().replayed_view();
    if (has_pages) pages_ = text;
    std::replace(text.begin(), text.end(), kNewPage, '\n');
    has_pages ? messages_.keep(text) : messages_.show(text);
}

}  // namespace oblong

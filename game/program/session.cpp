#include "game/program/session.h"

#include <utility>

#include "engine/files/arguments.h"
#include "engine/files/crosshair.h"
#include "game/input/key_names.h"
#include "game/simulation/goal.h"
#include "game/view/screenshot.h"
#include "game/view/shown_view.h"
#include "game/view/sign_colours.h"

namespace oblong {

Session::Session(std::shared_ptr<const LoadedLevel> loaded, const SessionSettings& settings, ViewOptions& view_options,
                 TickInputSource input, Platform& platform)
    : loaded_(std::move(loaded)),
      data_(loaded_->data),
      level_(loaded_->level),
      input_(std::move(input)),
      platform_(platform),
      view_options_(view_options),
      overlays_(settings.kind == SessionKind::Title ? no_overlays_ : view_options),
      settings_(settings),
      palette_(data_),
      text_colours_(text_colours_of(data_.palette)),
      menu_look_(data_.palette),
      before_(start_of(level_)),
      after_(before_),
      last_us_(platform.now_us()) {
    show("{help}: keys");
}

void Session::advance(const Controls& controls, std::uint64_t now_us) {
    const std::uint64_t elapsed_us = now_us - last_us_;
    last_us_ = now_us;
    has_drawn_ = false;
    played_us_ += elapsed_us;
    handle_commands(controls);
    Controls held = controls;
    if (!overlays_.lab.shows_panel) held.moves |= held.panel_moves;
    drag_split(shown_rect(view_options_.preferences, platform_.window_size()), overlays_.lab, held);
    input_.use(view_options_.preferences);
    input_.gather(held);
    play_due_ticks(elapsed_us);
}

bool Session::captures_mouse() const {
    return settings_.kind == SessionKind::Walk || (settings_.kind == SessionKind::Replay && !input_.is_replaying());
}

void Session::open_page(Action command, MenuPages& pages) {
    if (command == Action::Menu) pages.open_game();
    if (command == Action::ShowHelp) pages.open_keys();
    if (command == Action::Restart && settings_.kind == SessionKind::Walk) pages.open_restart();
}

// A walk that has ended is never without a page.
void Session::open_due_page(MenuPages& pages) {
    if (after_.has_ended && !input_.is_replaying()) pages.open_end();
}

void Session::handle_commands(const Controls& controls) {
    for (const Action command : controls.commands) {
        wants_screenshot_ |= command == Action::Screenshot;
        const std::string message = apply(command, view_options_, platform_.window_size());
        if (!message.empty()) show(message);
    }
}

// Makes what a command switched on, and frees what it switched off.
void Session::keep_what_is_on() {
    follow_mode();
    follow_colours();
    const bool needs_one = needs_lab(overlays_.lab);
    if (!needs_one || lab_text_scale_ != scaled_text().scale) lab_.reset();
    lab_text_scale_ = scaled_text().scale;
    if (needs_one && !lab_)
        lab_ = std::make_unique<Lab>(data_, level_, renderer_->mode(), drawn_colours_, lab_text_scale_);
    if (!overlays_.shows_four_aspects)
        four_aspects_.reset();
    else if (!four_aspects_)
        four_aspects_ = std::make_unique<FourAspects>(data_, level_);
    if (overlays_.log.is_empty())
        log_.reset();
    else if (!log_ || log_->channels() != overlays_.log)
        log_ = std::make_unique<FrameLog>(overlays_.log, standard_error_lines());
    if (overlays_.map == MapView::Off)
        map_.reset();
    else if (!map_)
        map_ = std::make_unique<Automap>(data_, level_, drawn_colours_);
    if (overlays_.wireframe == Wireframe::Off)
        wire_colour_.reset();
    else if (!wire_colour_)
        wire_colour_ = std::make_unique<LineColour>(data_.palette, sign_colours_of(drawn_colours_).edges);
    if (overlays_.cost_page == 0) {
        cost_.reset();
        cost_text_ = {};
    } else if (!cost_)
        cost_ = std::make_unique<FrameCost>(data_.palette, platform_.now_us());
}

// What draws is made for a mode.
void Session::follow_mode() {
    const ScreenMode& mode = view_options_.preferences.mode;
    if (renderer_ && renderer_->mode() == mode) return;
    lab_.reset();
    cost_.reset();
    renderer_ = std::make_unique<GameRenderer>(data_, level_, mode, settings_.workers);
}

// What draws signs is made for a scheme.
void Session::follow_colours() {
    if (drawn_colours_ == view_options_.preferences.colours) return;
    drawn_colours_ = view_options_.preferences.colours;
    lab_.reset();
    map_.reset();
    wire_colour_.reset();
}

void Session::play_due_ticks(std::uint64_t elapsed_us) {
    for (int due = clock_.advance(elapsed_us, view_options_.preferences.game_speed_100); due > 0; --due) {
        before_ = after_;
        const TickReport report = input_.play_tick(level_, after_);
        warn_of(report);
        palette_.note_tick(before_, after_);
        if (settings_.sound) settings_.sound->note_tick(before_, after_, report);
        show_level_message();
    }
}

// Of each kind once.
void Session::warn_of(const TickReport& report) {
    for (const std::string_view left : report.left())
        if (warned_of_.insert(left).second)
            print_warnings("oblong", data_.level_file,
                           {"more happens at once than a tick may do: " + std::string(left)});
}

GameView Session::shown_view() const {
    const std::int32_t fraction = clock_.fraction_16();
    const InterpolatedState state{before_, after_, fraction};
    const Preferences& preferences = view_options_.preferences;
    Camera camera = camera_at(state, input_.look_offset(fraction), preferences.field_of_view);
    if (preferences.view_bob_100 != 0 || preferences.view_roll_100 != 0) sway(state, preferences, camera);
    return {state, camera, overlays_.has_torch,
            other_view(overlays_.is_isometric, overlays_.zoom_degrees, camera, data_.level)};
}

Palette Session::palette_of(const GameView& view, const PaletteEffects& effects) const {
    return effects.is_plain() ? data_.palette : apply_palette_effects(data_.palette, effects, time_ms_at(view.state));
}

ShownPicture Session::draw(bool is_behind_menu) {
    keep_what_is_on();
    const Preferences& preferences = view_options_.preferences;
    const GameView view = shown_view();
    const Settings settings = settings_of(preferences);
    Settings shown_settings = settings;
    if (lab_) shown_settings.accuracy = shown_setting(overlays_.lab, settings.accuracy, last_us_);
    if (!std::exchange(has_drawn_, false) || lab_) renderer_->draw(view, shown_settings);
    PaletteEffects effects = palette_.effects_at(view, preferences.flashes, preferences.light(), preferences.has_dac6);
    if (is_behind_menu) effects.flash = {};  // it would wash the menu out
    note_cost(view, shown_settings, effects);
    if (log_) renderer_->note(view, shown_settings, last_us_, *log_);

    if (wire_colour_) draw_wires(view, shown_settings);
    if (!path_.empty()) draw_path(view, shown_settings);
    if (!is_behind_menu) draw_over(view, settings);
    const Palette palette = palette_of(view, effects);
    const Framebuffer canvas = renderer_->canvas();
    if (wants_screenshot_) show(save_screenshots(settings_.screenshot_folder, canvas, palette, renderer_->mode()));
    wants_screenshot_ = false;
    if (!is_behind_menu) draw_text();
    return {canvas, palette, shown_rect(preferences, platform_.window_size())};
}

Thumbnail Session::thumbnail() {
    follow_mode();
    const GameView view = shown_view();
    const Preferences& preferences = view_options_.preferences;
    renderer_->draw(view, settings_of(preferences));
    has_drawn_ = true;
    const PaletteEffects effects =
        palette_.effects_at(view, preferences.flashes, preferences.light(), preferences.has_dac6);
    return make_thumbnail(renderer_->canvas(), palette_of(view, effects));
}

void Session::restore(const GameState& state) {
    before_ = after_ = state;
    has_drawn_ = false;
}

KeyNames Session::key_names() const {
    return {view_options_.preferences.bindings, platform_, view_options_.uses_pad};
}

void Session::show(const std::string& message) {
    messages_.show(key_names().in(message));
}

void Session::show_level_message() {
    const bool is_new = after_.message.shown != before_.message.shown || after_.message.tick != before_.message.tick;
    std::string text;
    if (is_new && after_.message.shown >= 0) text = item(level_.messages, after_.message.shown);
    if (after_.items != before_.items) text += (text.empty() ? "" : "\n") + found_text(level_, before_, after_);
    if (!text.empty()) show(text);
}

// As large as the mode and the player want it.
TextColours Session::scaled_text() const {
    const Preferences& preferences = view_options_.preferences;
    return {text_colours_.bright, text_colours_.dark,
            text_scale_in(preferences.mode.width_px, preferences.mode.height_px, preferences.text_scale)};
}

void Session::draw_text() {
    text_.captions = settings_.sound ? settings_.sound->captions() : std::vector<std::string>();
    text_.cost = cost_ ? &cost_text_ : nullptr;
    text_.cost_page = overlays_.cost_page;
    const TextColours colours = scaled_text();
    const HudLayout layout =
        draw_hud(text_, messages_, played_us_, text_bottom_, colours, menu_look_.veil, renderer_->canvas());
    if (layout.cost_table.pages < overlays_.cost_page) overlays_.cost_page = 0;  // the last one was up
}

// Over the picture that was drawn last.
void Session::show_path(std::vector<Vec3<World>> points) {
    path_ = std::move(points);
    has_drawn_ = false;
}

void Session::draw_path(const GameView& view, const Settings& settings) {
    constexpr Rgb8 kRed{255, 40, 20};
    if (!path_colour_) path_colour_ = std::make_unique<LineColour>(data_.palette, kRed);
    renderer_->draw_path(path_, view, settings, path_colour_->style(overlays_.line_method));
}

void Session::draw_wires(const GameView& view, const Settings& settings) {
    const Framebuffer canvas = renderer_->canvas();
    if (overlays_.wireframe == Wireframe::Alone)
        fill_area(canvas, {0, 0, canvas.width_px, canvas.height_px}, text_colours_.dark);
    renderer_->draw_edges(view, settings, wire_colour_->style(overlays_.line_method));
}

void Session::draw_over(const GameView& view, const Settings& settings) {
    const Framebuffer canvas = renderer_->canvas();
    const Preferences& preferences = view_options_.preferences;
    const ScreenMode& mode = preferences.mode;
    const PresentRect rect = shown_rect(preferences, platform_.window_size());
    text_bottom_ = canvas.height_px - kTextMargin_px;
    text_.notes.clear();
    if (four_aspects_) {
        four_aspects_->draw(view, settings, mode, shown_pixel(rect, mode), scaled_text(), canvas);
        text_bottom_ = 0;  // their captions leave no room
        return;
    }
    if (map_) map_->draw(view, overlays_.map, overlays_.line_method, mode, settings, canvas);
    if (lab_) {
        const LabOptions& lab = overlays_.lab;
        text_bottom_ = lab_->draw(lab, view, settings, last_us_, cost_ != nullptr, canvas);
        for (const std::string& note : lab_->notes(lab, settings.accuracy, last_us_))
            text_.notes.push_back(key_names().in(note));
    }
    if (overlays_.inspects && !view.other) inspect(view);
    if (!overlays_.shows_aspect_guide) return;
    draw_aspect_guide(mode, text_colours_, canvas);
    text_.notes.push_back(aspect_caption(mode, settings.correct_aspect, preferences.shown_as, preferences.scaling,
                                         platform_.window_size()));
}

void Session::inspect(const GameView& view) {
    const std::vector<PlacedModel> models = placed_models(level_, view.state);
    draw_crosshair(renderer_->canvas(), text_colours_);
    text_.notes.push_back(describe_picked(data_.level, models, pick_ahead(data_.level, models, view.camera)));
}

void Session::note_cost(const GameView& view, const Settings& settings, const PaletteEffects& effects) {
    if (!cost_ || !cost_->note(view, settings, *renderer_, platform_.now_us())) return;
    cost_text_ = cost_->measure(view, settings, data_.palette, effects, *renderer_);
}

}  // namespace oblong

#include "game/session.h"

#include <filesystem>
#include <utility>

#include "game/screenshot.h"
#include "game/shown_view.h"
#include "tools/common/crosshair.h"

namespace oblong {

namespace {

constexpr Rgb8 kWireColour{255, 232, 96};

}  // namespace

Session::Session(std::shared_ptr<const LoadedLevel> loaded, const SessionSettings& settings, ViewOptions& view_options,
                 TickInputSource input, Platform& platform)
    : loaded_(std::move(loaded)),
      data_(loaded_->data),
      level_(loaded_->level),
      input_(std::move(input)),
      platform_(platform),
      view_options_(view_options),
      field_of_view_(settings.field_of_view),
      screenshot_folder_(settings.screenshot_folder),
      renderer_(data_, level_, settings.mode, settings.workers),
      palette_(data_, view_options.gamma_100),
      text_colours_(text_colours_of(data_.palette)),
      before_(start_of(level_)),
      after_(before_),
      last_us_(platform.now_us()) {
    platform_.set_title(("Oblong - " + std::filesystem::path(data_.level_file).stem().string()).c_str());
    show_message(hud_, "F1 Help", played_us_);
    keep_what_is_on();
}

void Session::advance(const Controls& controls, std::uint64_t now_us) {
    const std::uint64_t elapsed_us = now_us - last_us_;
    last_us_ = now_us;
    played_us_ += elapsed_us;
    handle_commands(controls);
    if (controls.pointer && controls.pointer->is_pressed) platform_.capture_mouse(true);
    Controls held = controls;
    if (!view_options_.lab.shows_panel) walk_by_panel_keys(held);
    drag_split(shown_rect(), view_options_.lab, held);
    input_.gather(held);
    play_due_ticks(elapsed_us);
}

void Session::pause(std::uint64_t now_us) {
    last_us_ = now_us;
    keep_what_is_on();
}

void Session::handle_commands(const Controls& controls) {
    for (const Command command : controls.commands) {
        wants_screenshot_ |= command == Command::Screenshot;
        const std::string message = apply(command, view_options_, renderer_.mode(), platform_.window_size());
        if (!message.empty()) show_message(hud_, message, played_us_);
    }
    if (!controls.commands.empty()) keep_what_is_on();
}

// Makes what a command switched on, and frees what it switched off.
void Session::keep_what_is_on() {
    if (!needs_lab(view_options_.lab))
        lab_.reset();
    else if (!lab_)
        lab_ = std::make_unique<Lab>(data_, level_, renderer_.mode());
    if (!view_options_.shows_four_aspects)
        four_aspects_.reset();
    else if (!four_aspects_)
        four_aspects_ = std::make_unique<FourAspects>(data_, level_);
    if (view_options_.log.is_empty())
        log_.reset();
    else if (!log_ || log_->channels() != view_options_.log)
        log_ = std::make_unique<FrameLog>(view_options_.log, standard_error_lines());
    if (view_options_.map == MapView::Off)
        map_.reset();
    else if (!map_)
        map_ = std::make_unique<Automap>(data_, level_);
    if (view_options_.wireframe == Wireframe::Off)
        wire_colour_.reset();
    else if (!wire_colour_)
        wire_colour_ = std::make_unique<LineColour>(data_.palette, kWireColour);
    if (!view_options_.shows_cost) {
        cost_.reset();
        hud_.cost = {};
    } else if (!cost_)
        cost_ = std::make_unique<FrameCost>(data_.palette, platform_.now_us());
}

PresentRect Session::shown_rect() const {
    PresentRect rect = layout(platform_.window_size(), renderer_.mode(), view_options_.shown_as, view_options_.scaling);
    rect.has_crt_look = view_options_.has_crt_look;
    return rect;
}

void Session::play_due_ticks(std::uint64_t elapsed_us) {
    for (int due = clock_.advance(elapsed_us); due > 0; --due) {
        before_ = after_;
        input_.play_tick(level_, after_);
        palette_.note_tick(before_, after_);
    }
}

ShownPicture Session::draw() {
    const std::int32_t fraction = clock_.fraction_16();
    const InterpolatedState state{before_, after_, fraction};
    const Camera camera = camera_at(state, input_.look_offset(fraction), field_of_view_);
    const GameView view{state, camera, view_options_.has_torch, other_view(view_options_, camera, data_.level)};
    const Settings settings = settings_of(view_options_);
    Settings shown_settings = settings;
    if (lab_) shown_settings.accuracy = shown_setting(view_options_.lab, settings.accuracy, last_us_);
    const std::uint64_t began_us = platform_.now_us();
    renderer_.draw(view, shown_settings);
    const PaletteEffects effects = palette_.effects_at(view, settings.flashes);
    note_cost(view, shown_settings, effects, began_us);
    if (log_) renderer_.note(view, shown_settings, last_us_, *log_);

    if (wire_colour_) draw_wires(view, shown_settings);
    draw_over(view, settings);
    const Palette palette =
        effects.is_plain() ? data_.palette : apply_palette_effects(data_.palette, effects, time_ms_at(state));
    const Framebuffer canvas = renderer_.canvas();
    if (wants_screenshot_)
        show_message(hud_, save_screenshots(screenshot_folder_, canvas, palette, renderer_.mode()), played_us_);
    wants_screenshot_ = false;
    hud_.shows_help = view_options_.shows_help;
    hud_.shows_end = after_.has_ended;
    if (hud_.shows_end) hud_.end_message = end_message(level_, after_);
    draw_hud(hud_, played_us_, text_bottom_, text_colours_, canvas);
    return {canvas, palette, shown_rect()};
}

// Over the picture that was drawn last.
void Session::draw_wires(const GameView& view, const Settings& settings) {
    const Framebuffer canvas = renderer_.canvas();
    if (view_options_.wireframe == Wireframe::Alone)
        fill_area(canvas, {0, 0, canvas.width_px, canvas.height_px}, text_colours_.dark);
    renderer_.draw_edges(view, settings, wire_colour_->style(view_options_.line_method));
}

void Session::draw_over(const GameView& view, const Settings& settings) {
    const Framebuffer canvas = renderer_.canvas();
    const ScreenMode& mode = renderer_.mode();
    text_bottom_ = canvas.height_px - kTextMargin_px;
    if (four_aspects_) {
        four_aspects_->draw(view, settings, mode, shown_pixel(shown_rect(), mode), text_colours_, canvas);
        text_bottom_ = 0;  // their captions leave no room
        return;
    }
    if (map_) map_->draw(view, view_options_.map, view_options_.line_method, mode, settings, canvas);
    if (lab_) text_bottom_ = lab_->draw(view_options_.lab, view, settings, last_us_, platform_, canvas);
    if (view_options_.inspects && !view.other) inspect(view);
    if (!view_options_.shows_aspect_guide) return;
    draw_aspect_guide(mode, text_colours_, canvas);
    const std::string caption = aspect_caption(mode, settings.correct_aspect, view_options_.shown_as,
                                               view_options_.scaling, platform_.window_size());
    text_bottom_ = draw_lines_above(text_bottom_, caption, text_colours_, canvas);
}

void Session::inspect(const GameView& view) {
    const std::vector<PlacedModel> models = placed_models(level_, view.state);
    const std::string text = describe_picked(data_.level, models, pick_ahead(data_.level, models, view.camera));
    draw_crosshair(renderer_.canvas(), text_colours_);
    text_bottom_ = draw_lines_above(text_bottom_, text, text_colours_, renderer_.canvas());
}

void Session::note_cost(const GameView& view, const Settings& settings, const PaletteEffects& effects,
                        std::uint64_t began_us) {
    if (!cost_ || !cost_->note(began_us, platform_.now_us())) return;
    hud_.cost = cost_->measure(view, settings, data_.palette, effects, renderer_);
}

}  // namespace oblong

#include "game/program/shown_overlays.h"

#include <utility>

#include "engine/programs/crosshair.h"
#include "game/view/sign_colours.h"

namespace oblong {
namespace {

constexpr Rgb8 kPathColour{255, 40, 20};

// Creates an object if it is wanted, else frees it.
template <class Object, class Make>
void keep(std::unique_ptr<Object>& object, bool is_wanted, Make make) {
    if (!is_wanted)
        object.reset();
    else if (!object)
        object = make();
}

}  // namespace

ShownOverlays::ShownOverlays(const LoadedLevel& loaded, const ViewOptions& view_options, Overlays& on,
                             const Platform& platform, OpenErrorMeter open_meter)
    : data_(loaded.data),
      level_(loaded.level),
      leak_path_(loaded.leak_path),
      view_options_(view_options),
      on_(on),
      platform_(platform),
      open_meter_(open_meter),
      text_colours_(text_colours_of(loaded.data.palette)) {}

void ShownOverlays::drag(Controls& controls) {
    drag_split(shown_rect(preferences(), platform_.window_size()), on_.lab, controls);
}

bool ShownOverlays::close_largest() {
    const bool is_any_open = lab_ || four_aspects_ || needs_lab(on_.lab) || on_.shows_four_aspects;
    lab_.reset();
    four_aspects_.reset();
    on_.lab.shows_panel = on_.lab.maps_errors = on_.lab.splits = on_.lab.flips = on_.shows_four_aspects = false;
    return is_any_open;
}

void ShownOverlays::follow(std::uint64_t now_us) {
    const ScreenMode mode = this->mode();
    text_colours_.scale = text_scale_in(mode.width_px, mode.height_px, preferences().text_scale);
    const MadeFor wanted{mode, preferences().colours, text_colours_.scale};
    if (std::exchange(made_for_, wanted) != wanted) {
        lab_.reset();
        map_.reset();
        cost_.reset();
        edge_colour_.reset();
    }
    keep(lab_, needs_lab(on_.lab), [&] {
        return std::make_unique<Lab>(data_, level_, wanted.mode, wanted.colours, wanted.text_scale, open_meter_);
    });
    keep(four_aspects_, on_.shows_four_aspects, [&] { return std::make_unique<FourAspects>(data_, level_); });
    if (log_ && log_->channels() != on_.log) log_.reset();
    keep(log_, !on_.log.is_empty(), [&] {
        return std::make_unique<FrameLog>(on_.log, [this, write = standard_error_lines()](const std::string& line) {
            write(line);
            noted_.push_back(line);
        });
    });
    if (!log_) logged_.clear();
    keep(map_, on_.map != MapView::Off, [&] { return std::make_unique<Automap>(data_, level_, wanted.colours); });
    keep(edge_colour_, on_.wireframe != Wireframe::Off,
         [&] { return std::make_unique<LineColour>(data_.palette, sign_colours_of(wanted.colours).edges); });
    keep(path_colour_, !leak_path_.empty(), [&] { return std::make_unique<LineColour>(data_.palette, kPathColour); });
    keep(cost_, on_.cost_page != 0, [&] { return std::make_unique<FrameCost>(data_.palette, now_us); });
}

Settings ShownOverlays::shown(Settings settings, std::uint64_t now_us) const {
    if (lab_) settings.accuracy = shown_setting(on_.lab, settings.accuracy, now_us);
    return settings;
}

void ShownOverlays::note(const GameView& view, const Settings& drawn, const PaletteEffects& effects,
                         std::uint64_t now_us, GameRenderer& renderer) {
    if (cost_) cost_->note(view, drawn, data_.palette, effects, now_us, renderer);
    if (log_) renderer.note(view, drawn, now_us, *log_);
    if (!noted_.empty()) logged_ = std::exchange(noted_, {});
}

void ShownOverlays::draw_lab_pictures(const GameView& view, const Settings& settings, std::uint64_t now_us,
                                      Framebuffer canvas) {
    if (lab_ && !four_aspects_) lab_->draw_pictures(on_.lab, view, settings, now_us, canvas);
}

void ShownOverlays::draw_lines(const GameView& view, const Settings& drawn, GameRenderer& renderer) {
    if (edge_colour_) {
        const Framebuffer canvas = renderer.drawn();
        if (on_.wireframe == Wireframe::Alone)
            fill_area(canvas, {0, 0, canvas.width_px, canvas.height_px}, text_colours_.dark);
        renderer.draw_edges(view, drawn, edge_colour_->style(on_.line_method));
    }
    if (path_colour_) renderer.draw_path(leak_path_, view, drawn, path_colour_->style(on_.line_method));
}

PanelText ShownOverlays::draw_panels(const GameView& view, const Settings& settings, std::uint64_t now_us,
                                     Framebuffer canvas) {
    const ScreenMode mode = this->mode();
    const WindowSize window = platform_.window_size();
    PanelText text{{}, canvas.height_px - kTextMargin_px};
    if (four_aspects_) {
        const Ratio pixel = shown_pixel(shown_rect(preferences(), window), mode);
        four_aspects_->draw(view, settings, mode, pixel, text_colours_, canvas);
        return {};  // their captions leave no room for notes
    }
    if (map_ && !on_.lab.shows_panel) map_->draw(view, on_.map, on_.line_method, mode, settings, canvas);
    if (lab_) {
        text.bottom = lab_->draw_panel(on_.lab, view, settings, cost_ != nullptr, canvas);
        for (const std::string& note : lab_->notes(on_.lab, view, settings.accuracy, now_us))
            text.notes.push_back(view_options_.key_names(platform_).in(note));
    }
    text.notes.insert(text.notes.end(), logged_.rbegin(), logged_.rend());  // the first line is the highest
    if (on_.inspects && !view.other) {
        const std::vector<PlacedModel> models = placed_models(level_, view.state);
        draw_crosshair(canvas, text_colours_);
        text.notes.push_back(describe_picked(data_.level, models, pick_ahead(data_.level, models, view.camera)));
    }
    if (on_.shows_aspect_guide) {
        draw_aspect_guide(mode, text_colours_, canvas);
        text.notes.push_back(
            aspect_caption(mode, settings.correct_aspect, preferences().shown_as, preferences().scaling, window));
    }
    return text;
}

void ShownOverlays::draw_text(PanelText panels, std::vector<std::string> captions, Messages& messages,
                              std::uint64_t played_us, const ColourTable& background, Framebuffer canvas) {
    const HudText text{std::move(captions), std::move(panels.notes), cost_ ? &cost_->text() : nullptr, on_.cost_page};
    const HudLayout layout = draw_hud(text, messages, played_us, panels.bottom, text_colours_, background, canvas);
    if (layout.cost_table.pages < on_.cost_page) on_.cost_page = 0;  // after the last page
}

}  // namespace oblong

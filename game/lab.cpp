#include "game/lab.h"

#include "game/comparison.h"

namespace oblong {

Lab::Lab(const GameData& data, const GameLevel& level, const ScreenMode& mode, ColourScheme scheme)
    : data_(data),
      level_(level),
      colours_(text_colours_of(data.palette)),
      panel_colours_(panel_colours_of(data.palette)),
      renderer_(data, level, mode),
      error_map_(data.palette, scheme) {}

ErrorMeter& Lab::meter() {
    if (!meter_) meter_.emplace(data_.level_file, level_);
    return *meter_;
}

std::int32_t Lab::draw(const LabOptions& options, const GameView& view, const Settings& settings, std::uint64_t now_us,
                       Framebuffer canvas) {
    Settings shown = settings;
    shown.accuracy = shown_setting(options, settings.accuracy, now_us);
    if (options.maps_errors) draw_errors(view, shown, canvas);
    if (options.splits) draw_exact_side(options, view, settings, canvas);
    std::int32_t bottom = canvas.height_px;
    if (options.shows_panel) bottom = draw_panel(options, view, settings, canvas);
    return draw_captions(options, settings.accuracy, now_us, bottom, canvas);
}

void Lab::draw_errors(const GameView& view, const Settings& shown, Framebuffer canvas) {
    error_map_.draw(meter().measure(view, shown, renderer_), canvas);
}

void Lab::draw_exact_side(const LabOptions& options, const GameView& view, Settings settings, Framebuffer canvas) {
    settings.accuracy = accuracy_of(Preset::Exact);
    renderer_.draw(view, settings);
    draw_split(options, renderer_.canvas(), colours_, canvas);
}

std::int32_t Lab::draw_panel(const LabOptions& options, const GameView& view, const Settings& settings,
                             Framebuffer canvas) {
    measures_.measure(view, settings, options.before, renderer_, meter(), data_.palette);
    draw_lab_panel(options, measures_.figures(), panel_colours_, canvas);
    return canvas.height_px - lab_panel_rows(canvas);
}

std::int32_t Lab::draw_captions(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us,
                                std::int32_t bottom, Framebuffer canvas) const {
    const std::string shown = setting_name(shown_setting(options, accuracy, now_us));
    if (options.maps_errors) {
        bottom = meter_->problem().empty()
                     ? error_map_.draw_legend(bottom, colours_, canvas)
                     : draw_lines_above(bottom, "No error: " + meter_->problem(), colours_, canvas);
    }
    if (options.splits) bottom = draw_split_names(options, shown, "exact", bottom, colours_, canvas);
    if (options.flips) bottom = draw_flip_names(options, accuracy, now_us, bottom, colours_, canvas);
    return bottom;
}

}  // namespace oblong

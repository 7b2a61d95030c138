#include "game/lab/lab.h"

#include <algorithm>
#include <string_view>

#include "engine/base/table.h"

namespace oblong {
namespace {

constexpr std::array<std::string_view, ErrorMap::kBands> kLabels{"0", "1/8", "1/4", "1/2", "1", "2", "4px"};
constexpr std::int32_t kSwatch_px = 4;

// A band's colour at 3/4 to all of its brightness, by the brightness of the picture's colour.
Rgb8 tinted(Rgb8 band, Rgb8 picture) {
    const std::int32_t weight = 192 + luminance_1000(picture) / 4000;
    const auto scaled = [&](std::uint8_t channel) { return static_cast<std::uint8_t>(channel * weight / 256); };
    return {scaled(band.red), scaled(band.green), scaled(band.blue)};
}

// The two settings that are flipped, the shown one in brackets.
std::string flip_text(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us) {
    if (options.before == accuracy) return "{flip} Both are " + setting_name(accuracy) + ": turn a dial";
    const bool shows_now = shown_setting(options, accuracy, now_us) == accuracy;
    const auto name = [](const Accuracy& setting, bool is_shown) {
        return is_shown ? "[" + setting_name(setting) + "]" : " " + setting_name(setting) + " ";
    };
    return "{flip} now " + name(accuracy, shows_now) + " before " + name(options.before, !shows_now);
}

}  // namespace

ErrorMap::ErrorMap(const Palette& palette, ColourScheme scheme) {
    const std::array<Rgb8, kBands>& colours = sign_colours_of(scheme).errors;
    for (std::size_t band = 0; band < kBands; ++band) {
        swatches_[band] = nearest_colour(palette, tinted(colours[band], {128, 128, 128}));
        for (std::size_t i = 0; i < palette.colours.size(); ++i)
            tints_[band][i] = nearest_colour(palette, tinted(colours[band], palette.colours[i]));
    }
}

std::size_t ErrorMap::band_of(float pixels) {
    const auto is_reached = [pixels](int step_256) { return pixels * 256 >= static_cast<float>(step_256); };
    return as_size(std::count_if(kSteps_256.begin(), kSteps_256.end(), is_reached));
}

void ErrorMap::draw(std::span<const TexelError> errors, Framebuffer canvas) const {
    if (errors.size() != pixel_count(canvas.width_px, canvas.height_px)) return;
    auto error = errors.begin();
    for (std::int32_t y = 0; y < canvas.height_px; ++y)
        for (std::int32_t x = 0; x < canvas.width_px; ++x, ++error)
            canvas.row(y)[x] = tints_[band_of(error->pixels)][canvas.row(y)[x]];
}

std::int32_t ErrorMap::draw_legend(std::int32_t bottom, TextColours colours, Framebuffer canvas) const {
    const std::int32_t line_px = kLineHeight_px * colours.scale, swatch_px = kSwatch_px * colours.scale;
    const std::int32_t top = bottom - line_px - swatch_px - kTextMargin_px;
    const std::int32_t width = (canvas.width_px - 2 * kTextMargin_px) / static_cast<std::int32_t>(kBands);
    for (std::size_t band = 0; band < kBands; ++band) {
        const std::int32_t x = kTextMargin_px + static_cast<std::int32_t>(band) * width;
        draw_text(canvas, x, top, kLabels[band], colours);
        fill_area(canvas, {x, top + line_px, width, swatch_px}, swatches_[band]);
    }
    return top;
}

Lab::Lab(const GameData& data, const GameLevel& level, const ScreenMode& mode, ColourScheme scheme,
         std::int32_t text_scale, OpenErrorMeter open_meter)
    : data_(data),
      level_(level),
      colours_(panel_colours_of(data.palette, text_scale)),
      renderer_(data, level, mode),
      open_meter_(open_meter),
      error_map_(data.palette, scheme) {}

ErrorMeter& Lab::meter() {
    if (!meter_) meter_ = open_meter_of(open_meter_, data_.level_file, level_);
    return *meter_;
}

void Lab::draw_pictures(const LabOptions& options, const GameView& view, const Settings& settings, std::uint64_t now_us,
                        Framebuffer canvas) {
    Settings shown = settings;
    shown.accuracy = shown_setting(options, settings.accuracy, now_us);
    if (options.maps_errors) error_map_.draw(meter().measure(view, shown, renderer_), canvas);
    if (!options.splits) return;
    shown.accuracy = accuracy_of(Preset::Exact);
    renderer_.draw(view, shown);
    draw_split(options, renderer_.canvas(), colours_.bright, canvas);
}

std::int32_t Lab::draw_panel(const LabOptions& options, const GameView& view, const Settings& settings, bool is_short,
                             Framebuffer canvas) {
    std::int32_t bottom = canvas.height_px;
    if (options.shows_panel) {
        measures_.measure(view, settings, options.before, renderer_, meter(), data_.palette);
        bottom = draw_lab_panel(options, measures_.figures(), colours_, is_short, canvas);
    }
    if (options.maps_errors && meter().problem_of(view).empty())
        bottom = error_map_.draw_legend(bottom, colours_.bright, canvas);
    return bottom;
}

std::vector<std::string> Lab::notes(const LabOptions& options, const GameView& view, const Accuracy& accuracy,
                                    std::uint64_t now_us) {
    std::vector<std::string> notes;
    const std::string problem = options.maps_errors ? meter().problem_of(view) : "";
    if (!problem.empty()) notes.push_back("No error: " + problem);
    if (options.splits)
        notes.push_back("{split} left: " + setting_name(shown_setting(options, accuracy, now_us)) + ", right: exact");
    if (options.flips) notes.push_back(flip_text(options, accuracy, now_us));
    return notes;
}

void draw_split(const LabOptions& options, Framebuffer right, TextColours colours, Framebuffer canvas) {
    const auto column = static_cast<std::int32_t>(std::int64_t{options.split_16} * canvas.width_px >> 16);
    for (std::int32_t y = 0; y < canvas.height_px; ++y)
        std::copy(right.row(y) + column, right.row(y) + canvas.width_px, canvas.row(y) + column);
    fill_area(canvas, {column - 1, 0, 1, canvas.height_px}, colours.dark);
    fill_area(canvas, {column, 0, 1, canvas.height_px}, colours.bright);
}

}  // namespace oblong

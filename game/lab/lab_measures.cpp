#include "game/lab/lab_measures.h"

#include <cmath>

namespace oblong {
namespace {

// The turns of a round: the current and the previous setting, the presets, costs, errors of places, wrong faces,
// errors of colours.
constexpr std::size_t kFirstPreset = 2, kCount = kFirstPreset + kPresets.size(), kErrors = kCount + 1,
                      kFaces = kErrors + 1, kColours = kFaces + 1, kTurns = kColours + 1;

// A setting with the dials of colour (light, shades, dither, coloured light, mip levels) of the preset `exact`.
Accuracy with_exact_colours(Accuracy accuracy) {
    const Accuracy exact = accuracy_of(Preset::Exact);
    accuracy.light = exact.light;
    accuracy.shades = exact.shades;
    accuracy.dithers_light = exact.dithers_light;
    accuracy.colour_levels = exact.colour_levels;
    accuracy.mip = exact.mip;
    accuracy.mip_bias = exact.mip_bias;
    accuracy.textures_floors = exact.textures_floors;
    return accuracy;
}

}  // namespace

ErrorSummary colour_errors(std::span<const std::uint8_t> picture, std::span<const std::uint8_t> exact,
                           const Palette& palette) {
    std::vector<float> errors;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        if (picture[i] == exact[i]) continue;
        const Rgb8 a = palette.colours[picture[i]], b = palette.colours[exact[i]];
        errors.push_back(std::hypot(static_cast<float>(a.red - b.red), static_cast<float>(a.green - b.green),
                                    static_cast<float>(a.blue - b.blue)));
    }
    return summarize_errors(std::move(errors));
}

LabMeasures::LabMeasures(FrameClock clock) : clock_(clock) {
    figures_.now.times = figures_.before.times = ViewTimes(clock);
    for (std::size_t i = 0; i < kPresets.size(); ++i)
        figures_.presets[i] = {accuracy_of(kPresets[i]), ViewTimes(clock)};
}

void LabMeasures::measure(const GameView& view, const Settings& now, const Accuracy& before, GameRenderer& renderer,
                          ErrorMeter& meter, const Palette& palette) {
    follow(now.accuracy, before);
    const std::size_t turn = turn_++ % kTurns;
    if (turn == kCount) return count(view, now, renderer);
    if (turn == kErrors) return note_errors(meter.measure(view, now, renderer), meter.problem_of(view));
    if (turn == kFaces) figures_.wrong_faces = meter.count_wrong_faces(view, now, renderer);
    if (turn == kFaces) return;
    if (turn == kColours) return compare_colours(view, now, renderer, palette);
    TimedSetting& setting = turn == 0   ? figures_.now
                            : turn == 1 ? figures_.before
                                        : figures_.presets[turn - kFirstPreset];
    time(setting, view, now, renderer);
}

// The current setting's times are kept when it becomes the previous one; times of older settings are dropped.
void LabMeasures::follow(const Accuracy& now, const Accuracy& before) {
    const TimedSetting was_now = figures_.now, was_before = figures_.before;
    const auto known = [&](const Accuracy& accuracy) {
        if (accuracy == was_now.accuracy) return was_now;
        return accuracy == was_before.accuracy ? was_before : TimedSetting{accuracy, ViewTimes(clock_)};
    };
    if (figures_.now.accuracy != now) figures_.now = known(now);
    if (figures_.before.accuracy != before) figures_.before = known(before);
}

void LabMeasures::time(TimedSetting& setting, const GameView& view, Settings settings, GameRenderer& renderer) {
    settings.accuracy = setting.accuracy;
    renderer.draw(view, settings);
    setting.times.time(view, settings, renderer);
    setting.frame_ns = setting.times.renderings().frame_ns();
}

void LabMeasures::count(const GameView& view, const Settings& now, GameRenderer& renderer) {
    renderer.draw(view, now);  // lights its surfaces
    figures_.events = events_of(renderer.draw_and_count(view, now), now.accuracy);
}

void LabMeasures::compare_colours(const GameView& view, Settings settings, GameRenderer& renderer,
                                  const Palette& palette) {
    const auto picture = [&] {
        renderer.draw(view, settings);
        const Framebuffer canvas = renderer.canvas();
        return std::vector<std::uint8_t>(canvas.pixels, canvas.row(canvas.height_px));
    };
    const std::vector<std::uint8_t> shown = picture();
    settings.accuracy = with_exact_colours(settings.accuracy);
    figures_.colour_errors = colour_errors(shown, picture(), palette);
    figures_.pixels = static_cast<std::int32_t>(shown.size());
}

void LabMeasures::note_errors(const std::vector<TexelError>& errors, const std::string& problem) {
    figures_.problem = problem;
    figures_.errors.reset();
    if (problem.empty()) figures_.errors = summarize_pixels(errors);
}

}  // namespace oblong

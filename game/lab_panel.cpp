#include "game/lab_panel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tools/common/font.h"
#include "tools/common/nearest_colour.h"

namespace oblong {
namespace {

constexpr std::int32_t kRow_px = 9, kMargin_px = 3, kBackground = 40;
constexpr std::size_t kDialRows = 7, kTextRows = 4;
constexpr std::int32_t kPanelRows_px = static_cast<std::int32_t>(1 + kDialRows + kTextRows) * kRow_px + 2 * kMargin_px;
constexpr std::size_t kDialColumns = 30;
constexpr std::int32_t kDials_px = kDialColumns * kGlyphAdvance_px;
constexpr std::int32_t kTimes_px = kMargin_px + kDials_px + 6, kNames_px = 8 * kGlyphAdvance_px;
constexpr std::int32_t kLongestBar_px = 20;
constexpr Rgb8 kDim{130, 130, 130}, kBar{60, 110, 190}, kChosen{20, 60, 130};

// The panel's canvas and colours.
struct Panel {
    Framebuffer canvas;
    const PanelColours& colours;

    void write(std::int32_t x, std::size_t row, std::string_view line, TextColours text) const {
        draw_text(canvas, x, y_of(row), line, text);
    }
    static std::int32_t y_of(std::size_t row) { return kMargin_px + static_cast<std::int32_t>(row) * kRow_px; }
};

// A value with the ways in which it can be turned.
std::string turnable(const Dial& dial, const Accuracy& accuracy) {
    const std::int32_t value = dial.get(accuracy);
    const bool is_first = value == dial.settings.front().value, is_last = value == dial.settings.back().value;
    return (is_first ? " " : "<") + value_text(dial, value) + (is_last ? " " : ">");
}

void draw_dial(const Dial& dial, bool is_chosen, const Accuracy& accuracy, std::size_t row, const Panel& panel) {
    const std::string value = is_chosen ? turnable(dial, accuracy) : value_text(dial, dial.get(accuracy)) + " ";
    const std::string caption(dial.caption.substr(0, kDialColumns - std::min(value.size(), kDialColumns)));
    const std::string gap(kDialColumns - std::min(kDialColumns, caption.size() + value.size()), ' ');
    if (is_chosen)
        fill_area(panel.canvas, {0, Panel::y_of(row), kMargin_px + kDials_px, kRow_px}, panel.colours.chosen);
    panel.write(kMargin_px, row, caption + gap + value,
                is_idle(dial, accuracy) ? panel.colours.dim : panel.colours.bright);
}

void draw_dials(const LabOptions& options, const Accuracy& accuracy, const Panel& panel) {
    const std::span<const Dial> dials = all_dials();
    const std::size_t above = kDialRows / 2, last_first = dials.size() - std::min(dials.size(), kDialRows);
    const std::size_t first = std::min(options.dial - std::min(options.dial, above), last_first);
    for (std::size_t i = first; i < std::min(first + kDialRows, dials.size()); ++i)
        draw_dial(dials[i], i == options.dial, accuracy, 1 + i - first, panel);
    // Which part of all is seen.
    const auto height = static_cast<std::int32_t>(kDialRows) * kRow_px, count = static_cast<std::int32_t>(dials.size());
    fill_area(panel.canvas,
              {kMargin_px + kDials_px + 1, Panel::y_of(1) + static_cast<std::int32_t>(first) * height / count, 1,
               static_cast<std::int32_t>(kDialRows) * height / count},
              panel.colours.bright.bright);
}

double longest_of(const LabFigures& figures) {
    double longest_ns = 1;
    const auto add = [&](const TimedSetting& setting) {
        if (setting.frame_ns) longest_ns = std::max(longest_ns, setting.frame_ns->median);
    };
    add(figures.now);
    add(figures.before);
    std::for_each(figures.presets.begin(), figures.presets.end(), add);
    return longest_ns;
}

void draw_time(std::string_view name, const TimedSetting& setting, double longest_ns, std::size_t row,
               TextColours colours, const Panel& panel) {
    panel.write(kTimes_px, row, name, colours);
    const std::optional<TimeSpread>& time = setting.frame_ns;
    if (!time) return panel.write(kTimes_px + kNames_px, row, "...", colours);
    const auto length = static_cast<std::int32_t>(time->median * kLongestBar_px / longest_ns);
    fill_area(panel.canvas, {kTimes_px + kNames_px, Panel::y_of(row) + 1, length, kRow_px - 3}, panel.colours.bar);
    panel.write(kTimes_px + kNames_px + length + 2, row,
                std::to_string(std::llround(time->median / 1000)) + spread_text(*time), colours);
}

// What the spread cannot tell from the setting now is dim: it is neither faster nor slower.
void draw_times(const LabFigures& figures, const Panel& panel) {
    const double longest_ns = longest_of(figures);
    const auto draw = [&](std::string_view name, const TimedSetting& setting, std::size_t row) {
        const bool is_apart =
            !figures.now.frame_ns || !setting.frame_ns || are_apart(*figures.now.frame_ns, *setting.frame_ns);
        draw_time(name, setting, longest_ns, row, is_apart ? panel.colours.bright : panel.colours.dim, panel);
    };
    draw_time("now", figures.now, longest_ns, 1, panel.colours.bright, panel);
    draw("before", figures.before, 2);
    for (std::size_t i = 0; i < kPresets.size(); ++i) draw(name_of(kPresets[i]), figures.presets[i], 3 + i);
}

std::string with_decimals(double value, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string three_digits(double value) {
    return with_decimals(value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0);
}

std::string describe_errors(const LabFigures& figures) {
    if (!figures.problem.empty()) return "No error: " + figures.problem;
    if (!figures.errors) return "Texels out of place, pixels: ...";
    if (figures.errors->count == 0) return "Texels out of place, pixels: no texels in view";
    return "Texels out of place, pixels: rms " + three_digits(figures.errors->rms) + ", worst " +
           three_digits(figures.errors->max);
}

std::string describe_colours(const LabFigures& figures) {
    const std::string of = "Colours off, of 442: ";
    if (!figures.colour_errors) return of + "...";
    const ErrorSummary& errors = *figures.colour_errors;
    if (errors.count == 0) return of + "none (light, mip levels)";
    const double percent = 100.0 * static_cast<double>(errors.count) / figures.pixels;
    return of + "rms " + three_digits(errors.rms) + ", worst " + three_digits(errors.max) + ", in " +
           with_decimals(percent, percent < 9.95 ? 1 : 0) + " %";
}

std::string describe_operations(const Operations& operations) {
    return "Work: " + short_count(operations.adds.total()) + " adds, " +
           short_count(operations.multiplications.total()) + " muls, " + short_count(operations.divisions.total()) +
           " divs, " + short_count(operations.lookups) + " look-ups";
}

std::string describe_frame_rates(const LabFigures& figures) {
    const auto rate = [&](std::size_t processor) {
        const double frames = figures.frame_rates[processor];
        return with_decimals(frames, frames < 9.95 ? 1 : 0);
    };
    return "Frames/s: 386/33 " + rate(0) + ", 486/66 " + rate(1) + ", Pentium/90 " + rate(2);
}

}  // namespace

std::string short_count(std::int64_t count) {
    if (count < 1000) return std::to_string(count);
    const bool is_large = count >= 999'500;
    const double value = static_cast<double>(count) / (is_large ? 1e6 : 1e3);
    return with_decimals(value, value < 9.95 ? 1 : 0) + (is_large ? "M" : "k");
}

std::int32_t lab_panel_rows(Framebuffer canvas) {
    return std::min(kPanelRows_px, canvas.height_px);
}

PanelColours panel_colours_of(const Palette& palette) {
    const TextColours bright = text_colours_of(palette);
    return {bright,
            {nearest_colour(palette, kDim), bright.dark},
            nearest_colour(palette, kBar),
            nearest_colour(palette, kChosen),
            darker_colours(palette, kBackground)};
}

void draw_lab_panel(const LabOptions& options, const LabFigures& figures, const PanelColours& colours,
                    Framebuffer canvas) {
    const std::int32_t rows = lab_panel_rows(canvas);
    const Area area{0, canvas.height_px - rows, canvas.width_px, rows};
    recolour_area(canvas, area, colours.background);
    const Panel panel{part_of(canvas, area), colours};
    panel.write(kMargin_px, 0, "Dials, the coarser the faster", panel.colours.dim);
    panel.write(kTimes_px, 0, "us; dim: as now", panel.colours.dim);
    draw_dials(options, figures.now.accuracy, panel);
    draw_times(figures, panel);
    panel.write(kMargin_px, 1 + kDialRows, describe_errors(figures), panel.colours.bright);
    panel.write(kMargin_px, 2 + kDialRows, describe_colours(figures), panel.colours.bright);
    panel.write(kMargin_px, 3 + kDialRows, describe_operations(figures.operations), panel.colours.bright);
    panel.write(kMargin_px, 4 + kDialRows, describe_frame_rates(figures), panel.colours.bright);
}

}  // namespace oblong

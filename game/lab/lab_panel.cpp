#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "engine/base/table.h"
#include "engine/draw/drawing.h"
#include "engine/surface/palette.h"
#include "game/lab/lab.h"

namespace oblong {
namespace {

// In pixels of letters, each of `scale` columns and rows of the canvas.
constexpr std::int32_t kRow_px = 9, kMargin_px = 3, kBackground = 40;
constexpr std::int32_t kTwoColumns_px = 320;  // the least width for times beside the dials
constexpr std::size_t kDialRows = kPresets.size() + 2, kDialColumns = 30;
constexpr std::int32_t kDials_px = kDialColumns * kGlyphAdvance_px;
constexpr std::int32_t kTimes_px = kMargin_px + kDials_px + 6, kNames_px = 8 * kGlyphAdvance_px;
constexpr std::int32_t kLongestBar_px = 15;
constexpr Rgb8 kDim{130, 130, 130}, kBar{60, 110, 190}, kChosen{20, 60, 130};

struct Panel {
    Framebuffer canvas;
    const PanelColours& colours;

    void write(std::int32_t x, std::size_t row, std::string_view line, TextColours text) const {
        draw_text(canvas, x * text.scale, y_of(row) * text.scale, line, text);
    }
    void fill(const Area& area, std::uint8_t colour) const {
        const std::int32_t scale = colours.bright.scale;
        fill_area(canvas, {area.x * scale, area.y * scale, area.width * scale, area.height * scale}, colour);
    }
    static std::int32_t y_of(std::size_t row) { return kMargin_px + static_cast<std::int32_t>(row) * kRow_px; }
};

struct RowSpan {
    std::size_t top, count;
};

// A value between "<" and ">", if it can be turned that way.
std::string turnable(const Dial& dial, const Accuracy& accuracy) {
    const std::int32_t value = dial.get(accuracy);
    const bool is_first = value == dial.settings.front().value, is_last = value == dial.settings.back().value;
    return (is_first ? " " : "<") + value_text(dial, value) + (is_last ? " " : ">");
}

// A caption on the left, a value on the right; on two lines if one is too short.
std::string dial_text(const Dial& dial, const std::string& value, std::size_t columns) {
    const std::string caption(dial.caption);
    const std::size_t used = caption.size() + value.size();
    if (used < columns) return caption + std::string(columns - used, ' ') + value;
    return caption + "\n" + std::string(columns - std::min(columns, value.size()), ' ') + value;
}

// The first dial that is shown: the chosen one is in the middle, with all of its lines.
std::size_t first_dial(std::size_t turned, const Accuracy& accuracy, std::size_t columns, std::size_t rows) {
    const std::span<const Dial> dials = all_dials();
    std::size_t first = std::min(turned - std::min(turned, rows / 2), dials.size() - std::min(dials.size(), rows));
    const auto is_double = [&](std::size_t i) {
        return dials[i].caption.size() + turnable(dials[i], accuracy).size() >= columns;
    };
    const auto rows_to_turned = [&] {
        std::size_t count = 0;
        for (std::size_t i = first; i <= turned; ++i) count += is_double(i) ? 2 : 1;
        return count;
    };
    while (first < turned && rows_to_turned() > rows) ++first;
    return first;
}

// The dials around the chosen one, in these rows.
void draw_dials(const LabOptions& options, const Accuracy& accuracy, std::size_t columns, RowSpan rows,
                const Panel& panel) {
    const std::span<const Dial> dials = all_dials();
    const std::size_t first = first_dial(options.dial, accuracy, columns, rows.count), end = rows.top + rows.count;
    const auto width = static_cast<std::int32_t>(columns) * kGlyphAdvance_px;
    std::size_t row = rows.top;
    for (std::size_t i = first; i < dials.size() && row < end; ++i) {
        const bool is_chosen = i == options.dial;
        const std::string value =
            is_chosen ? turnable(dials[i], accuracy) : value_text(dials[i], dials[i].get(accuracy)) + " ";
        const std::string text = dial_text(dials[i], value, columns);
        const std::vector<std::string_view> lines = lines_of(text, width);
        if (row + lines.size() > end) break;
        if (is_chosen)
            panel.fill({0, Panel::y_of(row), kMargin_px + width, kRow_px * static_cast<std::int32_t>(lines.size())},
                       panel.colours.chosen);
        for (const std::string_view line : lines)
            panel.write(kMargin_px, row++, line,
                        is_idle(dials[i], accuracy) ? panel.colours.dim : panel.colours.bright);
    }
    // A scroll bar.
    const auto height = static_cast<std::int32_t>(rows.count) * kRow_px,
               count = static_cast<std::int32_t>(dials.size());
    panel.fill({kMargin_px + width + 1, Panel::y_of(rows.top) + static_cast<std::int32_t>(first) * height / count, 1,
                std::max(static_cast<std::int32_t>(rows.count) * height / count, 1)},
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

// Microseconds, and half of the interquartile range.
std::string spread_text(const TimedSetting& setting, bool has_spread) {
    const std::optional<TimeSpread>& time = setting.frame_ns;
    if (!time) return "...";
    return std::to_string(std::llround(time->median / 1000)) + (has_spread ? spread_text(*time) : "");
}

// Whether the spread is too large to tell which of two is faster.
bool are_alike(const TimedSetting& a, const TimedSetting& b) {
    return a.frame_ns && b.frame_ns && !are_apart(*a.frame_ns, *b.frame_ns);
}

void draw_time(std::string_view name, const TimedSetting& setting, double longest_ns, std::size_t row,
               TextColours colours, const Panel& panel) {
    panel.write(kTimes_px, row, name, colours);
    const double time_ns = setting.frame_ns ? setting.frame_ns->median : 0;
    const auto length = static_cast<std::int32_t>(time_ns * kLongestBar_px / longest_ns);
    panel.fill({kTimes_px + kNames_px, Panel::y_of(row) + 1, length, kRow_px - 3}, panel.colours.bar);
    panel.write(kTimes_px + kNames_px + length + 2, row, spread_text(setting, true), colours);
}

// A time within the spread of the current setting's is dim: neither faster nor slower.
void draw_times(const LabFigures& figures, const Panel& panel) {
    panel.write(kTimes_px, 0, "us; dim: same as now", panel.colours.dim);
    const double longest_ns = longest_of(figures);
    const auto draw = [&](std::string_view name, const TimedSetting& setting, std::size_t row) {
        const bool is_alike = are_alike(figures.now, setting);
        draw_time(name, setting, longest_ns, row, is_alike ? panel.colours.dim : panel.colours.bright, panel);
    };
    draw_time("now", figures.now, longest_ns, 1, panel.colours.bright, panel);
    draw("before", figures.before, 2);
    for (std::size_t i = 0; i < kPresets.size(); ++i) draw(name_of(kPresets[i]), figures.presets[i], 3 + i);
}

// Without the spread, "~" stands between times that it does not separate.
std::string describe_times(const LabFigures& figures, bool has_spread) {
    const std::string between = has_spread ? " us " : are_alike(figures.now, figures.before) ? " ~ " : "  ";
    return "now " + spread_text(figures.now, has_spread) + between + "before " +
           spread_text(figures.before, has_spread);
}

std::string with_decimals(double value, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string describe_errors(const LabFigures& figures) {
    if (!figures.problem.empty()) return "No error: " + figures.problem;
    const std::string of = "Texels off, px: ";
    if (!figures.errors) return of + "...";
    if (figures.errors->count == 0) return of + "no texels in view";
    return of + "rms " + three_digits(figures.errors->rms) + ", worst " + three_digits(figures.errors->max) +
           "; wrong face: " + (figures.wrong_faces ? std::to_string(*figures.wrong_faces) : "...");
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

std::string describe_cost(const Events& events) {
    const auto rate = [&](Processor processor) {
        const double frames = static_cast<double>(frame_rate_10(processor, cycles_on(processor, events))) / 10;
        return with_decimals(frames, frames < 9.95 ? 1 : 0);
    };
    return short_count(cost_of(events, Currency::Instructions)) + " instructions; 386 " + rate(Processor::I386) +
           ", 486 " + rate(Processor::I486) + ", P90 " + rate(Processor::Pentium) + " frames/s";
}

}  // namespace

std::string three_digits(double value) {
    return with_decimals(value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0);
}

std::string short_count(std::int64_t count) {
    if (count < 1000) return std::to_string(count);
    const bool is_large = count >= 999'500;
    const double value = static_cast<double>(count) / (is_large ? 1e6 : 1e3);
    return with_decimals(value, value < 9.95 ? 1 : 0) + (is_large ? "M" : "k");
}

PanelColours panel_colours_of(const Palette& palette, std::int32_t scale) {
    TextColours bright = text_colours_of(palette);
    bright.scale = scale;
    return {bright,
            {nearest_colour(palette, kDim), bright.dark, scale},
            nearest_colour(palette, kBar),
            nearest_colour(palette, kChosen),
            darker_colours(palette, kBackground)};
}

std::int32_t draw_lab_panel(const LabOptions& options, const LabFigures& figures, const PanelColours& colours,
                            bool is_short, Framebuffer canvas) {
    const std::int32_t scale = colours.bright.scale, width = canvas.width_px / scale;
    const bool has_two_columns = width >= kTwoColumns_px && !is_short;
    const std::size_t columns =
        has_two_columns ? kDialColumns : as_size(std::max((width - 2 * kMargin_px) / kGlyphAdvance_px, 1));
    std::vector<std::string> texts{describe_errors(figures), describe_colours(figures)};
    if (!has_two_columns) texts.insert(texts.begin(), describe_times(figures, !is_short || width >= kTwoColumns_px));
    if (!is_short) texts.push_back(describe_cost(figures.events));
    const std::int32_t most_px = panel_room_px(canvas, scale);
    const std::int32_t room_px =
        (is_short ? std::min(most_px, canvas.height_px / 3) : most_px) / scale - 2 * kMargin_px;
    const auto most_rows = as_size(std::max(room_px, kRow_px) / kRow_px);
    const std::size_t head = has_two_columns ? 1 : 0, least_dials = has_two_columns ? kDialRows : std::size_t{2};
    std::vector<std::string> lines;
    for (const std::string& text : texts) {
        const auto more = lines_of(text, width - 2 * kMargin_px);
        if (!lines.empty() && head + least_dials + lines.size() + more.size() > most_rows) break;
        lines.insert(lines.end(), more.begin(), more.end());
    }
    const std::size_t dial_rows =
        is_short ? 2 : std::clamp(most_rows - std::min(most_rows, head + lines.size()), std::size_t{1}, kDialRows);
    const auto rows = static_cast<std::int32_t>(head + dial_rows + lines.size());
    const std::int32_t height = std::min((rows * kRow_px + 2 * kMargin_px) * scale, canvas.height_px);
    const Area area{0, canvas.height_px - height, canvas.width_px, height};
    recolour_area(canvas, area, colours.background);
    const Panel panel{part_of(canvas, area), colours};
    if (has_two_columns) {
        panel.write(kMargin_px, 0, "Dials", panel.colours.dim);
        draw_times(figures, panel);
    }
    draw_dials(options, figures.now.accuracy, columns, {head, dial_rows}, panel);
    for (std::size_t i = 0; i < lines.size(); ++i)
        panel.write(kMargin_px, head + dial_rows + i, lines[i], panel.colours.bright);
    return canvas.height_px - height;
}

}  // namespace oblong

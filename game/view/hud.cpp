#include "game/view/hud.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

#include "engine/base/table.h"

namespace oblong {
namespace {

constexpr std::uint64_t kLeast_us = 2'500'000, kLetter_us = 60'000;
constexpr std::size_t kMostKept = 32;

std::vector<std::string_view> wrapped(const std::string& text, std::int32_t columns) {
    return lines_of(text, columns * kGlyphAdvance_px);
}

constexpr std::uint64_t kMeasured_us = 500'000;
constexpr int kCostBackground = 90;  // brightness, of 256
// In pixels of letters.
constexpr std::int32_t kCostRow_px = 9, kEffectsLeft_px = 148, kTwoCostColumns_px = 320;
constexpr int kPassName = 11, kEffectName = 17;  // the longest names

// Microseconds in four characters: "0.3", "48.2", "7235".
std::string short_time(double time_ns) {
    const std::int64_t tenths_us = std::llround(std::max(time_ns, 0.0) / 100);
    const std::string whole = std::to_string(tenths_us / 10);
    return tenths_us < 1000 ? whole + "." + std::to_string(tenths_us % 10) : whole;
}

// In the table: from 10 ms on, as under DOS, in milliseconds: "26ms".
std::string table_time(double time_ns) {
    constexpr double kLeast_ns = 9'999'500;
    return time_ns < kLeast_ns ? short_time(time_ns) : std::to_string(std::llround(time_ns / 1e6)) + "ms";
}

std::string text_of(const PlanLine& line, int name_width, bool has_pixels) {
    char text[64];
    const std::string name(line.name), time = table_time(line.nanoseconds);
    if (has_pixels)
        std::snprintf(text, sizeof text, "%-*.*s%6lld%5s", name_width, name_width, name.c_str(),
                      static_cast<long long>(line.pixels), time.c_str());
    else
        std::snprintf(text, sizeof text, "%-*.*s%5s", name_width, name_width, name.c_str(), time.c_str());
    return text;
}

// A column of the table: its heading and its lines on all pages.
struct Column {
    std::int32_t left;
    std::string head;
    std::vector<std::string> lines;
};

Column column_of(std::int32_t left, const std::vector<PlanLine>& lines, int name_width, bool has_pixels) {
    const std::string head = has_pixels ? "pixels   us" : "   us";
    Column column{left, lines.empty() ? "" : std::string(as_size(name_width), ' ') + head, {}};
    for (const PlanLine& line : lines) column.lines.push_back(text_of(line, name_width, has_pixels));
    return column;
}

std::vector<Column> columns_of(const CostText& text, std::int32_t width) {
    if (width >= kTwoCostColumns_px)
        return {column_of(kTextMargin_px, text.passes, kPassName, true),
                column_of(kEffectsLeft_px, text.effects, kEffectName, true)};
    std::vector<PlanLine> all = text.passes;
    all.insert(all.end(), text.effects.begin(), text.effects.end());
    return {column_of(kTextMargin_px, all, kEffectName, false)};
}

std::string head_of(const CostText& text, std::int32_t page, std::int32_t pages) {
    if (pages == 1) return text.frame;
    return text.frame + ", page " + std::to_string(page) + " of " + std::to_string(pages);
}

// The effects that are no passes.
std::vector<PlanLine> other_lines(std::vector<PlanLine> effects, const std::vector<PlanLine>& passes) {
    std::erase_if(effects, [&](const PlanLine& effect) {
        return std::any_of(passes.begin(), passes.end(),
                           [&](const PlanLine& pass) { return pass.name == effect.name; });
    });
    return effects;
}

double palette_time_ns(const Palette& palette, const PaletteEffects& effects, std::int64_t time_ms) {
    const std::int64_t began_ns = steady_clock_ns();
    apply_palette_effects(palette, effects, time_ms);
    return static_cast<double>(steady_clock_ns() - began_ns);
}

// How long a text is shown: 60 ms a letter, at least 2.5 s.
std::uint64_t reading_time_us(const std::string& text) {
    return std::max(kLeast_us, letters_in(text) * kLetter_us);
}

}  // namespace

std::string describe_rate(Processor machine, std::int64_t cycles) {
    const std::int64_t tenths = frame_rate_10(machine, cycles);
    return std::string(name_of(machine)) + ": " + std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) +
           " frames/s";
}

FrameCost::FrameCost(const Palette& palette, std::uint64_t now_us)
    : text_{darker_colours(palette, kCostBackground), {}, {}, {}}, since_us_(now_us) {}

void FrameCost::note(const GameView& view, const Settings& settings, const Palette& palette,
                     const PaletteEffects& effects, std::uint64_t now_us, GameRenderer& renderer) {
    times_.time(view, settings, renderer);
    ++frames_;
    const std::uint64_t since_us = now_us - since_us_;
    if (since_us < kMeasured_us) return;
    const std::uint64_t frames_a_second = frames_ * 1'000'000 / since_us;
    since_us_ = now_us;
    frames_ = 0;
    const RenderingTimes& times = times_.renderings();
    const TimeSpread frame = times.frame_ns();
    text_.frame = short_time(frame.median) + " us " + spread_text(frame) + ", " + std::to_string(frames_a_second) +
                  " frames/s, " + std::to_string(view.state.after.active_movers.size()) + " movers";
    const FrameCounts counts = renderer.draw_and_count(view, settings);
    text_.passes = times.pass_lines(renderer.plan(), counts);
    text_.effects = other_lines(times.effect_lines(renderer.plan(), counts), text_.passes);
    if (!effects.is_plain())
        text_.effects.push_back({"palette", 0, palette_time_ns(palette, effects, time_ms_at(view.state))});
}

void Messages::keep(const std::string& text) {
    std::erase(all_, text);
    all_.insert(all_.begin(), text);
    if (all_.size() > kMostKept) all_.pop_back();
}

void Messages::show(std::string text) {
    keep(text);
    const std::uint64_t time_us = reading_time_us(text);
    parts_.assign(1, {std::move(text), time_us});
    is_up_ = false;
}

void Messages::pass_time(std::uint64_t now_us) {
    const std::uint64_t elapsed_us = now_us - std::exchange(last_us_, now_us);
    if (!std::exchange(is_up_, false)) return;
    Part& up = parts_.front();
    up.left_us -= std::min(up.left_us, elapsed_us);
    if (up.left_us == 0) parts_.erase(parts_.begin());
}

// The rest becomes the next part; "..." says that it follows, in place of words if need be.
void Messages::split_first(std::int32_t columns, std::size_t most_lines) {
    constexpr std::string_view kFollows = " ...", kSpace = " \n";
    Part& first = parts_.front();
    const std::vector<std::string_view> all = wrapped(first.text, columns);
    if (all.size() <= most_lines) return;
    const std::string whole = first.text;
    const std::size_t most =
        whole.find_last_not_of(kSpace, as_size(all[most_lines].data() - first.text.data()) - 1) + 1;
    const auto is_too_long = [&](std::size_t length) {
        first.text = whole.substr(0, length) + std::string(kFollows);
        return wrapped(first.text, columns).size() > most_lines;
    };
    std::size_t kept = most;
    while (kept != std::string::npos && kept > 0 && is_too_long(kept)) kept = whole.find_last_of(kSpace, kept - 1);
    if (kept == std::string::npos || kept == 0) first.text = whole.substr(0, kept = most);  // a narrow room
    std::string rest = whole.substr(whole.find_first_not_of(kSpace, kept));
    const std::uint64_t time_us = reading_time_us(rest);
    first.left_us = std::min(first.left_us, reading_time_us(first.text));
    parts_.insert(parts_.begin() + 1, {std::move(rest), time_us});
}

std::vector<std::string> Messages::lines(std::uint64_t now_us, std::int32_t columns, std::size_t most_lines) {
    pass_time(now_us);
    if (parts_.empty() || most_lines == 0) return {};
    split_first(columns, most_lines);
    is_up_ = true;
    const std::vector<std::string_view> shown = wrapped(parts_.front().text, columns);
    return {shown.begin(), shown.end()};
}

namespace {

constexpr std::int32_t kTextGap_px = 2;
constexpr std::size_t kMostMessageLines = 3;  // so that the picture stays visible

std::int32_t line_px(TextColours colours) {
    return kLineHeight_px * colours.scale;
}

std::int32_t height_of(const std::string& text, TextColours colours, Framebuffer canvas) {
    return static_cast<std::int32_t>(lines_across(text, colours, canvas).size()) * line_px(colours);
}

// Pages that fit into `room_px` rows; the frame's time is always shown.
CostTable lay_out_cost(const CostText& text, std::int32_t room_px, TextColours colours, Framebuffer canvas) {
    CostTable table;
    if (text.frame.empty()) return table;
    std::size_t longest = 0;
    for (const Column& column : columns_of(text, canvas.width_px / colours.scale))
        longest = std::max(longest, column.lines.size());
    const auto head_px = [&](std::int32_t pages) { return height_of(head_of(text, pages, pages), colours, canvas); };
    const std::int32_t row_px = kCostRow_px * colours.scale;
    table.height_px = head_px(1) + 2;
    table.lines = longest;
    if (longest > 0 && table.height_px + row_px * static_cast<std::int32_t>(longest + 1) > room_px) {
        constexpr std::int32_t kManyPages = 10;  // a page number as wide as any
        const std::int32_t lines = (room_px - head_px(kManyPages) - 2) / row_px - 1;
        table.lines = as_size(std::max(lines, 0));
        if (table.lines > 0) table.height_px = head_px(kManyPages) + 2;
    }
    if (table.lines == 0) return table;
    table.height_px += row_px * static_cast<std::int32_t>(table.lines + 1);
    table.pages = static_cast<std::int32_t>((longest + table.lines - 1) / table.lines);
    return table;
}

// Draws a page, from 1, so that it ends above the row `bottom`: the plan's passes at the left, effects at the right; in
// a canvas too narrow for both, effects follow the passes, without counts of pixels.
void draw_cost(const CostText& text, const CostTable& table, std::int32_t page, std::int32_t bottom,
               TextColours colours, Framebuffer canvas) {
    if (text.frame.empty()) return;
    recolour_area(canvas, {0, bottom - table.height_px, canvas.width_px, table.height_px}, text.background);
    const std::string head = head_of(text, page, table.pages);
    draw_lines(bottom - table.height_px + 1, head, colours, canvas);
    if (table.lines == 0) return;
    const std::int32_t scale = colours.scale, row_px = kCostRow_px * scale;
    const std::size_t first = as_size(page - 1) * table.lines;
    for (const Column& column : columns_of(text, canvas.width_px / scale)) {
        std::int32_t y = bottom - static_cast<std::int32_t>(table.lines + 1) * row_px;
        if (first < column.lines.size()) draw_text(canvas, column.left * scale, y, column.head, colours);
        for (std::size_t i = first; i < std::min(first + table.lines, column.lines.size()); ++i)
            draw_text(canvas, column.left * scale, y += row_px, column.lines[i], colours);
    }
}

// Takes `height` rows from the bottom of a room; none if it has fewer.
RowRange take_below(std::int32_t height, RowRange& room) {
    if (height <= 0 || height > room.height()) return {};
    room.bottom -= height;
    return {room.bottom, room.bottom + height};
}

template <class Lines>
void draw_on_background(RowRange rows, const Lines& lines, TextColours colours, const ColourTable& background,
                        Framebuffer canvas) {
    std::int32_t y = rows.top + colours.scale;
    for (const std::string_view line : lines) {
        if (y + line_px(colours) - colours.scale > rows.bottom) return;
        const std::int32_t width = text_width_px(line) * colours.scale + kTextMargin_px;
        recolour_area(canvas, {kTextMargin_px / 2, y - colours.scale, width, line_px(colours)}, background);
        draw_text(canvas, kTextMargin_px, y, line, colours);
        y += line_px(colours);
    }
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
}

}  // namespace

HudLayout lay_out_hud(const HudText& text, bool has_messages, std::int32_t bottom, TextColours colours,
                      Framebuffer canvas) {
    HudLayout layout;
    const std::int32_t top = std::max(kTextGap_px, colours.scale);
    RowRange below{top, std::max(bottom, top)};
    if (has_messages) below.top += std::min(line_px(colours), below.height());
    const std::string captions = joined(text.captions);
    if (!captions.empty()) layout.captions = take_below(height_of(captions, colours, canvas), below);
    for (const std::string& note : text.notes)
        layout.notes.push_back(take_below(height_of(note, colours, canvas), below));
    if (text.cost != nullptr) {
        const std::int32_t panels_top = canvas.height_px - panel_room_px(canvas, colours.scale);
        const std::int32_t room_px = below.bottom - std::max(below.top, panels_top);
        layout.cost_table = lay_out_cost(*text.cost, room_px, colours, canvas);
        if (text.cost_page <= layout.cost_table.pages) layout.cost = take_below(layout.cost_table.height_px, below);
    }
    layout.messages = {top, std::max(below.bottom, top)};
    return layout;
}

HudLayout draw_hud(const HudText& text, Messages& messages, std::uint64_t now_us, std::int32_t bottom,
                   TextColours colours, const ColourTable& background, Framebuffer canvas) {
    const HudLayout layout = lay_out_hud(text, !messages.is_empty(), bottom, colours, canvas);
    if (layout.cost.height() > 0)
        draw_cost(*text.cost, layout.cost_table, text.cost_page, layout.cost.bottom, colours, canvas);
    for (std::size_t i = 0; i < text.notes.size(); ++i)
        draw_on_background(layout.notes[i], lines_across(text.notes[i], colours, canvas), colours, background, canvas);
    const std::string captions = joined(text.captions);
    draw_on_background(layout.captions, lines_across(captions, colours, canvas), colours, background, canvas);
    const std::int32_t columns = (canvas.width_px - 2 * kTextMargin_px) / (kGlyphAdvance_px * colours.scale);
    const auto most_lines = std::min(kMostMessageLines, as_size(layout.messages.height() / line_px(colours)));
    draw_on_background(layout.messages, messages.lines(now_us, std::max(columns, 1), most_lines), colours, background,
                       canvas);
    return layout;
}

}  // namespace oblong

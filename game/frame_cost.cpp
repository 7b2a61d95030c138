#include "game/frame_cost.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tools/common/font.h"

namespace oblong {
namespace {

constexpr std::uint64_t kMeasured_us = 500'000;
constexpr int kBackground = 90;  // of 256: how bright it is
constexpr std::int32_t kRow_px = 9, kEffectsLeft_px = 148;
constexpr int kPassName = 11, kEffectName = 17;  // the longest ones

// Microseconds in four characters: "0.3", "48.2", "7235".
std::string short_time(double time_ns) {
    const std::int64_t tenths_us = std::llround(std::max(time_ns, 0.0) / 100);
    const std::string whole = std::to_string(tenths_us / 10);
    return tenths_us < 1000 ? whole + "." + std::to_string(tenths_us % 10) : whole;
}

std::string text_of(const PlanLine& line, int name_width) {
    char text[64];
    std::snprintf(text, sizeof text, "%-*.*s%6lld%5s", name_width, name_width, std::string(line.name).c_str(),
                  static_cast<long long>(line.pixels), short_time(line.nanoseconds).c_str());
    return text;
}

void draw_column(std::int32_t x, std::int32_t bottom, const std::vector<PlanLine>& lines, int name_width,
                 TextColours colours, Framebuffer canvas) {
    std::int32_t y = bottom - (static_cast<std::int32_t>(lines.size()) + 1) * kRow_px;
    if (lines.empty()) return;
    char head[64];
    std::snprintf(head, sizeof head, "%*s", name_width + 11, "pixels   us");
    draw_text(canvas, x, y, head, colours);
    for (const PlanLine& line : lines) draw_text(canvas, x, y += kRow_px, text_of(line, name_width), colours);
}

// Without effects that are passes of their own.
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

}  // namespace

std::int32_t cost_height_px(const CostText& text, Framebuffer canvas) {
    if (text.frame.empty()) return 0;
    const auto lines = static_cast<std::int32_t>(lines_across(text.frame, {}, canvas).size());
    const auto rows = static_cast<std::int32_t>(std::max(text.passes.size(), text.effects.size()));
    return lines * kLineHeight_px + (rows == 0 ? 0 : (rows + 1) * kRow_px) + 2;
}

void draw_cost(const CostText& text, std::int32_t bottom, TextColours colours, Framebuffer canvas) {
    if (text.frame.empty()) return;
    const std::int32_t height = cost_height_px(text, canvas);
    recolour_area(canvas, {0, bottom - height, canvas.width_px, height}, text.background);
    bottom = draw_lines_above(bottom, text.frame, colours, canvas);
    draw_column(kTextMargin_px, bottom, text.passes, kPassName, colours, canvas);
    draw_column(kEffectsLeft_px, bottom, text.effects, kEffectName, colours, canvas);
}

FrameCost::FrameCost(const Palette& palette, std::uint64_t now_us)
    : background_(darker_colours(palette, kBackground)), since_us_(now_us) {}

bool FrameCost::note(const GameView& view, const Settings& settings, GameRenderer& renderer, std::uint64_t now_us) {
    times_.time(view, settings, renderer);
    ++frames_;
    const std::uint64_t since_us = now_us - since_us_;
    if (since_us < kMeasured_us) return false;
    frames_a_second_ = frames_ * 1'000'000 / since_us;
    since_us_ = now_us;
    frames_ = 0;
    return true;
}

CostText FrameCost::measure(const GameView& view, const Settings& settings, const Palette& palette,
                            const PaletteEffects& effects, GameRenderer& renderer) const {
    CostText text{background_, {}, {}, {}};
    const RenderingTimes& times = times_.renderings();
    const TimeSpread frame = times.frame_ns();
    text.frame = short_time(frame.median) + " us " + spread_text(frame) + " a frame, " +
                 std::to_string(frames_a_second_) + " frames a second, " +
                 std::to_string(view.state.after.active_movers.size()) + " movers";
    const FrameCounts counts = renderer.draw_and_count(view, settings);
    text.passes = times.pass_lines(renderer.plan(), counts);
    text.effects = other_lines(times.effect_lines(renderer.plan(), counts), text.passes);
    if (!effects.is_plain())
        text.effects.push_back({"palette", 0, palette_time_ns(palette, effects, time_ms_at(view.state))});
    return text;
}

}  // namespace oblong

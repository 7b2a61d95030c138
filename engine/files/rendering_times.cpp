#include "engine/files/rendering_times.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "engine/base/table.h"

namespace oblong {

namespace {

/// The pass with the name of an effect; kPassCount: none.
std::size_t pass_of(std::string_view effect) {
    const auto pass = std::find_if(kPasses.begin(), kPasses.end(), [&](const Pass& one) { return one.name == effect; });
    return as_size(pass - kPasses.begin());
}

/// The walk's part of the claims. It is sampled, so it may be slightly negative: clamped.
std::int64_t walk_ns(const PassTimes& times) {
    return std::clamp(times.walk_ns, std::int64_t{0}, times.claims_ns);
}

PlanLine line_of(std::string_view name, std::int64_t pixels, const TimeSpread& times) {
    return {name, pixels, times.median, times.low, times.high};
}

}  // namespace

std::int64_t steady_clock_ns() {
    return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

TimeSpread spread_of(std::vector<double> times_ns) {
    std::sort(times_ns.begin(), times_ns.end());
    const std::size_t last = times_ns.size() - 1, quarter = last / 4;
    return {(times_ns[last / 2] + times_ns[(last + 1) / 2]) / 2, times_ns[quarter], times_ns[last - quarter]};
}

std::string spread_text(const TimeSpread& times) {
    const double half = (times.high - times.low) / 2;
    return "+-" + std::to_string(std::lround(std::ceil(times.median > 0 ? 100 * half / times.median : 0))) + "%";
}

void RenderingTimes::add(std::int64_t taken_ns) {
    if (renderings_.size() == most_) renderings_.erase(renderings_.begin());
    renderings_.push_back({taken_ns, watch_});
}

template <class TimeOf>
std::vector<double> RenderingTimes::times_of(TimeOf time_of) const {
    std::vector<double> times;
    for (const Rendering& rendering : renderings_) times.push_back(static_cast<double>(time_of(rendering)));
    return times;
}

TimeSpread RenderingTimes::frame_ns() const {
    return spread_of(times_of([](const Rendering& rendering) { return rendering.frame_ns; }));
}

std::vector<PlanLine> RenderingTimes::pass_lines(const FramePlan& plan, const FrameCounts& counts) const {
    std::vector<PlanLine> lines;
    std::vector<double> rest = times_of([](const Rendering& rendering) { return rendering.frame_ns; });
    double other_ns = spread_of(rest).median;
    const auto add = [&](std::string_view name, std::int64_t pixels, auto time_of) {
        const std::vector<double> times =
            times_of([&](const Rendering& rendering) { return time_of(rendering.times); });
        std::transform(rest.begin(), rest.end(), times.begin(), rest.begin(), std::minus<>());
        lines.push_back(line_of(name, pixels, spread_of(times)));
        other_ns -= lines.back().nanoseconds;
    };
    std::int64_t owned_pixels = 0;
    for (std::size_t i = 0; i < kPassCount; ++i)
        if (kPasses[i].owns_pixels) owned_pixels += counts.pass_pixels[i];
    add("walk", 0, walk_ns);
    add("claims", owned_pixels, [](const PassTimes& times) { return times.claims_ns - walk_ns(times); });
    for (std::size_t i = 0; i < kPassCount; ++i)
        if (plan.passes[i])
            add(kPasses[i].name, counts.pass_pixels[i], [i](const PassTimes& times) { return times.passes_ns[i]; });
    const TimeSpread other = spread_of(rest);
    lines.push_back({"other", 0, other_ns, other.low, other.high});
    return lines;
}

std::vector<PlanLine> RenderingTimes::effect_lines(const FramePlan& plan, const FrameCounts& counts) const {
    std::vector<PlanLine> lines;
    for (std::size_t index = 0; index < kEffectCount; ++index) {
        const auto effect = static_cast<Effect>(index);
        if (!plan.effects.has(effect)) continue;
        const std::size_t pass = pass_of(kEffectNames[index]);
        const std::vector<double> times = times_of([&](const Rendering& rendering) {
            const std::int64_t own_ns = pass < kPassCount ? rendering.times.passes_ns[pass] : 0;
            return std::clamp(own_ns + rendering.times.effects_ns[index], std::int64_t{0},
                              rendering.frame_ns);  // as walk_ns()
        });
        lines.push_back(line_of(kEffectNames[index], counts.effect_pixels[index], spread_of(times)));
    }
    return lines;
}

}  // namespace oblong

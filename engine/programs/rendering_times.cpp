#include "engine/programs/rendering_times.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numeric>

#include "engine/base/table.h"
#include "engine/frame/passes.h"

namespace oblong {

namespace {

/// The walk's part of the claims. It is sampled, so it may be slightly negative: clamped.
std::int64_t walk_ns(const PassTimes& times) {
    return std::clamp(times.walk_ns, std::int64_t{0}, times.claims_ns);
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
    const long percent = std::lround(std::ceil(times.median > 0 ? 100 * half / times.median : 0));
    return percent > 99 ? " busy" : "+-" + std::to_string(percent) + "%";
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

std::vector<const RenderingTimes::Rendering*> RenderingTimes::middle_half() const {
    std::vector<const Rendering*> middle;
    for (const Rendering& rendering : renderings_) middle.push_back(&rendering);
    std::sort(middle.begin(), middle.end(),
              [](const Rendering* a, const Rendering* b) { return a->frame_ns < b->frame_ns; });
    const auto quarter = static_cast<std::ptrdiff_t>((middle.size() - 1) / 4);
    return {middle.begin() + quarter, middle.end() - quarter};
}

/// Medians of parts do not add up to that of the whole.
template <class TimeOf>
PlanLine RenderingTimes::line_of(std::string_view name, std::int64_t pixels, TimeOf time_of) const {
    double part_ns = 0, whole_ns = 0;
    for (const Rendering* const rendering : middle_half()) {
        part_ns += static_cast<double>(time_of(*rendering));
        whole_ns += static_cast<double>(rendering->frame_ns);
    }
    const TimeSpread spread = spread_of(times_of(time_of));
    const double share_ns = whole_ns > 0 ? part_ns / whole_ns * frame_ns().median : 0;
    return {name, pixels, share_ns, std::min(spread.low, share_ns), std::max(spread.high, share_ns)};
}

std::vector<PlanLine> RenderingTimes::pass_lines(const FramePlan& plan, const FrameCounts& counts) const {
    std::int64_t owned_pixels = 0;
    for (std::size_t i = 0; i < kPassCount; ++i)
        if (kPasses[i].owns_pixels) owned_pixels += counts.pass_pixels[i];
    std::vector<PlanLine> lines{line_of("walk", 0, [](const Rendering& rendering) { return walk_ns(rendering.times); }),
                                line_of("claims", owned_pixels, [](const Rendering& rendering) {
                                    return rendering.times.claims_ns - walk_ns(rendering.times);
                                })};
    for (std::size_t i = 0; i < kPassCount; ++i)
        if (plan.passes[i])
            lines.push_back(line_of(kPasses[i].name, counts.pass_pixels[i],
                                    [i](const Rendering& rendering) { return rendering.times.passes_ns[i]; }));
    lines.push_back(line_of("other", 0, [](const Rendering& rendering) {
        const auto& passes_ns = rendering.times.passes_ns;
        return std::accumulate(passes_ns.begin(), passes_ns.end(), rendering.frame_ns - rendering.times.claims_ns,
                               std::minus<>());
    }));
    return lines;
}

std::vector<PlanLine> RenderingTimes::effect_lines(const FramePlan& plan, const FrameCounts& counts) const {
    std::vector<PlanLine> lines;
    for (std::size_t index = 0; index < kEffectCount; ++index) {
        const auto effect = static_cast<Effect>(index);
        if (!plan.effects.has(effect)) continue;
        const std::size_t pass = pass_of(effect);
        lines.push_back(line_of(kEffectNames[index], counts.effect_pixels[index], [&](const Rendering& rendering) {
            const std::int64_t own_ns = pass < kPassCount ? rendering.times.passes_ns[pass] : 0;
            return std::clamp(own_ns + rendering.times.effects_ns[index], std::int64_t{0},
                              rendering.frame_ns);  // as walk_ns()
        }));
    }
    return lines;
}

}  // namespace oblong

#include "engine/frame/pass_times.h"

#include "engine/frame/frame_counts.h"

namespace oblong {

namespace {

/// The pass that an effect has for itself.
std::optional<Pass> pass_of(Effect effect) {
    switch (effect) {
        case Effect::Sky:
            return Pass::Sky;
        case Effect::Liquid:
            return Pass::Liquid;
        case Effect::Mirror:
            return Pass::Mirror;
        case Effect::Shadows:
            return Pass::Shadows;
        case Effect::Models:
            return Pass::Models;
        case Effect::Fog:
            return Pass::Fog;
        case Effect::Underwater:
            return Pass::Underwater;
        default:
            return std::nullopt;
    }
}

}  // namespace

std::vector<PlanLine> pass_lines(const FramePlan& plan, const FrameCounts& counts, const PassTimes& times) {
    std::vector<PlanLine> lines;
    for (const Pass pass : plan.passes) {
        const auto index = static_cast<std::size_t>(pass);
        lines.push_back({kPassNames[index], counts.pass_pixels[index], times.passes_ns[index]});
    }
    return lines;
}

std::vector<PlanLine> effect_lines(const FramePlan& plan, const FrameCounts& counts, const PassTimes& times) {
    std::vector<PlanLine> lines;
    for (std::size_t index = 0; index < kEffectCount; ++index) {
        const auto effect = static_cast<Effect>(index);
        if (!plan.effects.has(effect)) continue;
        const std::optional<Pass> pass = pass_of(effect);
        const std::int64_t taken_ns = pass ? times.passes_ns[static_cast<std::size_t>(*pass)] : times.effects_ns[index];
        lines.push_back({kEffectNames[index], counts.effect_pixels[index], taken_ns});
    }
    return lines;
}

}  // namespace oblong

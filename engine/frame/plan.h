#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/frame/claims.h"
#include "engine/scene/effects.h"

namespace oblong {

/// A step of a frame that writes pixels, in the order in which they run.
enum class Pass : std::uint8_t { Walls, Flat, Liquid, Sky, Mirror, Shadows, Fog, Models, SeeThrough, Underwater };
inline constexpr std::size_t kPassCount = 10;
inline constexpr std::array<std::string_view, kPassCount> kPassNames{
    "walls", "flat", "liquid", "sky", "mirror", "shadows", "fog", "models", "see_through", "underwater"};

/// Whether a pass reads or covers pixels that others have drawn.
constexpr bool draws_over_others(Pass pass) {
    return pass >= Pass::Shadows;
}

/// What a frame runs: nothing else does. A pass is on it if something that owns pixels needs it.
struct FramePlan {
    std::vector<Pass> passes;
    EffectSet effects;  ///< those that own pixels
};

/// The plan for these claims.
FramePlan plan_frame(const Claims& claims);

}  // namespace oblong

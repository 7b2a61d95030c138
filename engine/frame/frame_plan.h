#pragma once

#include <bitset>
#include <cstddef>

#include "engine/scene/level_effects.h"

namespace oblong {

/// Of kPasses.
inline constexpr std::size_t kPassCount = 11;

/// The passes that a frame runs: those with work.
struct FramePlan {
    std::bitset<kPassCount> passes;  ///< by index in kPasses
    EffectSet effects;               ///< that own pixels, also in mirrors; final when the passes have run
};

}  // namespace oblong

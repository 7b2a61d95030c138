#pragma once

#include <cstdint>

#include "engine/accuracy/accuracy.h"
#include "engine/scene/level_effects.h"
#include "engine/scene/light_styles.h"

namespace oblong {

/// What the player or the developer sets; with level, camera and time it determines a frame.
struct Settings {
    Accuracy accuracy;
    EffectSet allowed_effects = EffectSet::all();
    Flashes flashes = Flashes::Full;
    std::int32_t brightness_100 = 100;  ///< percent, of the light on lit surfaces; clamped to the brightest shade
    bool correct_aspect = true;         ///< false: the projection assumes square pixels (F2 in the game)
    bool operator==(const Settings&) const = default;
};

}  // namespace oblong

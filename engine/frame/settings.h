#pragma once

#include "engine/accuracy/accuracy.h"
#include "engine/scene/effects.h"

namespace oblong {

/// What the player or the developer sets; together with level, camera and time it determines a frame.
struct Settings {
    Accuracy accuracy;
    EffectSet allowed_effects = EffectSet::all();
    bool correct_aspect = true;  ///< false: the projection assumes square pixels (F2 in the game)
};

}  // namespace oblong

#pragma once

#include <cstdint>

#include "engine/files/level_sounds.h"
#include "engine/level/level.h"
#include "game/simulation/geometry.h"
#include "game/sound/sound_table.h"

namespace oblong {

/// Something that sounds at a place.
struct SoundSource {
    Sound sound = Sound::Wind;
    std::int32_t variant = 0;
    Box box;                                ///< sounds from all over it; meaningless for sounds without a range
    std::uint32_t serial = 0;               ///< tells apart what begins at different times; 0 for loops
    ModelIndex model = kWorldModel;         ///< that makes the sound, and is not in its own way
    std::int32_t own = LevelSounds::kNone;  ///< what is heard in its place, of the level's own
};

}  // namespace oblong

#pragma once

#include <cstdint>

#include "engine/files/sound_file.h"
#include "engine/level/level.h"
#include "game/simulation/geometry.h"
#include "game/sound/sound_table.h"

namespace oblong {

/// A source of sound.
struct SoundSource {
    Sound sound = Sound::Wind;
    std::int32_t variant = 0;
    Box box;                                ///< sounds from all of it; unused for sounds without a range
    std::uint32_t serial = 0;               ///< distinguishes one-shots; 0 for loops
    ModelIndex model = kWorldModel;         ///< that makes the sound, and does not block it
    std::int32_t own = LevelSounds::kNone;  ///< the level's own sound that replaces it
};

}  // namespace oblong

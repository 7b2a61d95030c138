#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/files/sound_file.h"
#include "engine/level/level.h"

namespace oblong {

struct LevelSound {
    std::string name;  ///< in the entities: a path below a folder
    std::string file;
    SoundSamples samples;
};

/// The sounds that a level's entities name in their key "noise".
struct LevelSounds {
    static constexpr std::int32_t kNone = -1;

    std::vector<LevelSound> sounds;       ///< one for each name
    std::vector<std::int32_t> by_entity;  ///< into `sounds`, or kNone, in the order of Level::entities
    std::vector<std::string> warnings;    ///< of sounds that are left out
};

/// Reads the files that a level's entities name (of the classes that have the key), each from the first folder that has
/// it. A missing file is a warning, one for each name. Throws FileError for a file that is no sound: see
/// decode_sound().
LevelSounds read_level_sounds(const Level& level, const std::vector<std::string>& folders);

}  // namespace oblong

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/files/flac.h"
#include "engine/level/level.h"

namespace oblong {

/// A file of sound that entities of a level name.
struct LevelSound {
    std::string name;  ///< as they name it: a path below a folder
    std::string file;
    SoundSamples samples;
};

/// The sounds that a level's entities have of their own, by their key "noise".
struct LevelSounds {
    static constexpr std::int32_t kNone = -1;

    std::vector<LevelSound> sounds;       ///< one for each name
    std::vector<std::int32_t> by_entity;  ///< into `sounds`, or kNone, in the order of Level::entities
    std::vector<std::string> warnings;    ///< what is not heard, and why
};

/// Reads the files that a level's entities name (of the classes that have such a key), each from the first of these
/// folders that has it. A file that is missing is a warning, one for each name. Throws FileError for one that is no
/// sound: see decode_sound().
LevelSounds read_level_sounds(const Level& level, const std::vector<std::string>& folders);

}  // namespace oblong

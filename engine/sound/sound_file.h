#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// The contents of a sound file: one channel of 16 bits.
struct SoundSamples {
    std::int32_t rate_hz = 0;
    std::vector<std::int16_t> samples;
};

/// Decodes a FLAC file (RFC 9639) of one channel and 16 bits a sample, with integers only. Throws InputError with the
/// offset of the error: a damaged frame (each has a checksum), more channels, no samples.
SoundSamples decode_flac(std::span<const std::uint8_t> file);

/// Decodes a sound: FLAC as decode_flac() reads it, or WAV (RIFF) with PCM of 8 or 16 bits, of one channel or of two,
/// which are mixed, also one from a pipe, without its length. Throws InputError with the offset of the error.
SoundSamples decode_sound(std::span<const std::uint8_t> file);

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

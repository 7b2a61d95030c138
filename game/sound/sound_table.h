#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/table.h"
#include "engine/level/level.h"
#include "engine/sound/sound_file.h"
#include "game/simulation/geometry.h"

namespace oblong {

/// The sounds of the game.
enum class Sound : std::uint8_t {
    StepStone,
    StepWood,
    StepMetal,
    StepEarth,
    StepCarpet,
    StepWater,
    Land,
    Swim,
    WaterIn,
    WaterOut,
    DoorStart,
    DoorMove,
    DoorStop,
    SlabStart,
    SlabMove,
    SlabStop,
    GateStart,
    GateMove,
    GateStop,
    LiftStart,
    LiftMove,
    LiftStop,
    TrainStart,
    TrainMove,
    TrainStop,
    Button,
    Teleport,
    Hurt,
    Lens,
    Key,
    Message,
    Played,
    Secret,
    LevelEnd,
    MenuMove,
    MenuAccept,
    MenuBack,
    Wind,
    Rain,
    Water,
    Slime,
    Lava,
    Fire,
    Hum,
    Sparks,
    Bubbles,
    Teleporter,
    UnderWater
};
inline constexpr std::size_t kSoundCount = as_size(Sound::UnderWater) + 1;

/// When a sound's caption is shown.
enum class CaptionRule : std::uint8_t {
    Always,    ///< each time that it begins
    Sometimes  ///< for continuing or frequent sounds: only after a silence
};

/// The properties of a sound.
struct SoundRow {
    const char* file;       ///< in the folder of sounds, without a variant's number and ".flac"
    std::int32_t variants;  ///< files, numbered from 1 if there are several, played in turn; 0: always a level's own
    const char* caption;    ///< "": none
    std::int32_t range;     ///< beyond which it is not heard, in world units; 0: it is at the listener
    std::int32_t gain_256;  ///< its volume at distance 0, up to 256
    std::int32_t length_ticks;  ///< of the longest variant, rounded up; 0: it is a loop
    CaptionRule caption_rule = CaptionRule::Always;

    bool is_loop() const { return length_ticks == 0; }
};

const SoundRow& row_of(Sound sound);

/// The sound of a row's `file`; nothing if no row has it.
std::optional<Sound> find_sound(std::string_view file);

/// "step_stone2.flac"; `variant` from 0.
std::string file_of(Sound sound, std::int32_t variant);

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

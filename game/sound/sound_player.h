#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/platform/sound.h"
#include "game/sound/audible.h"

namespace oblong {

/// Plays the sounds that are heard: starts, adjusts and stops voices by the differences from tick to tick.
class SoundPlayer {
  public:
    /// The output outlives it. Reads the files of all sounds, each from the first of the folders that has it. Throws
    /// FileError.
    SoundPlayer(SoundOutput& output, const std::vector<std::string>& folders);

    /// Sets the sounds that AudibleSound::own is an index of. Each file is given to the output once.
    void take_own(const LevelSounds& own);

    /// Makes the voices those of `sounds`, `volume_256` from 0 to 256. One-shots are started once.
    void play(std::span<const AudibleSound> sounds, std::int32_t volume_256);
    /// Plays a sound of a menu.
    void play_once(Sound sound, std::int32_t volume_256);
    void stop_all();

  private:
    struct Key {
        Sound sound;
        std::uint32_t serial;
        auto operator<=>(const Key&) const = default;
    };
    struct Voice {
        SoundOutput::VoiceNumber number;
        VoiceLevels levels;
    };
    SoundOutput::SoundNumber number_of(const AudibleSound& sound) const;

    SoundOutput& output_;
    std::vector<SoundOutput::SoundNumber> first_numbers_;  // by sound, of the first variant
    std::vector<SoundOutput::SoundNumber> own_numbers_;
    std::map<std::string, SoundOutput::SoundNumber> number_of_file_;  // of all own sounds so far
    std::map<Key, Voice> voices_;
};

}  // namespace oblong

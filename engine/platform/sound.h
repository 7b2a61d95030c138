#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace oblong {

/// How loud a voice is on each side, 0 to 256, and whether it sounds as if through a wall.
struct VoiceLevels {
    std::int32_t left_256 = 0, right_256 = 0;
    bool is_muffled = false;
    bool operator==(const VoiceLevels&) const = default;
};

/// What plays sounds: a Mixer, which a device is heard through, or what a test records.
class SoundOutput {
  public:
    using SoundNumber = std::int32_t;  ///< of those added, from 0
    using VoiceNumber = std::int64_t;  ///< of what is being played, 0 and up; no two voices have the same
    static constexpr VoiceNumber kNoVoice = -1;

    virtual ~SoundOutput() = default;

    /// Adds a sound of one channel, at least one sample.
    virtual SoundNumber add_sound(std::span<const std::int16_t> samples, std::int32_t rate_hz) = 0;

    /// Begins to play a sound, once or again and again until it is stopped; kNoVoice where all voices are taken.
    virtual VoiceNumber start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) = 0;
    virtual bool is_playing(VoiceNumber voice) const = 0;
    /// Changes a voice's levels, within some milliseconds so that no step is heard.
    virtual void adjust(VoiceNumber voice, const VoiceLevels& levels) = 0;
    /// Fades a voice out, and frees it.
    virtual void stop(VoiceNumber voice) = 0;
    /// Holds all voices where they are, or lets them go on. Music and voices that begin later are not held.
    virtual void hold_voices(bool are_held) = 0;

    /// Plays a tracker module again and again, `volume_256` from 0 to 256; replaces the music before it. Throws
    /// InputError for bytes that are none.
    virtual void play_music(std::span<const std::uint8_t> module_file, std::int32_t volume_256) = 0;
    virtual void set_music_volume(std::int32_t volume_256) = 0;
    virtual void stop_music() = 0;
};

/// Opens a SoundOutput; throws std::runtime_error where there is no device.
using OpenSound = std::function<std::unique_ptr<SoundOutput>()>;

}  // namespace oblong

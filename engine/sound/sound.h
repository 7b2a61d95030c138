#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace oblong {

/// A voice's volume on each side, 0 to 256, and whether it sounds as if through a wall.
struct VoiceLevels {
    std::int32_t left_256 = 0, right_256 = 0;
    bool is_muffled = false;

    VoiceLevels times_256(std::int32_t gain_256) const {
        return {left_256 * gain_256 / 256, right_256 * gain_256 / 256, is_muffled};
    }
    bool operator==(const VoiceLevels&) const = default;
};

/// Plays sounds: a Mixer for a device, or a recorder for tests.
class SoundOutput {
  public:
    using SoundNumber = std::int32_t;  ///< of sounds, in the order in which they were added, from 0
    using VoiceNumber = std::int64_t;  ///< of playing sounds, 0 and up; never reused
    static constexpr VoiceNumber kNoVoice = -1;

    virtual ~SoundOutput() = default;

    /// Adds a sound of one channel, at least one sample.
    virtual SoundNumber add_sound(std::span<const std::int16_t> samples, std::int32_t rate_hz) = 0;

    /// Starts a sound, once or in a loop until it is stopped; kNoVoice if all voices are in use.
    virtual VoiceNumber start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) = 0;
    virtual bool is_playing(VoiceNumber voice) const = 0;
    /// Changes a voice's levels, gradually over some milliseconds to avoid clicks.
    virtual void adjust(VoiceNumber voice, const VoiceLevels& levels) = 0;
    /// Fades a voice out, and frees it.
    virtual void stop(VoiceNumber voice) = 0;
    /// Pauses all voices, or resumes them. Music and voices that begin later are not paused.
    virtual void hold_voices(bool are_held) = 0;

    /// Plays a tracker module in a loop, `volume_256` from 0 to 256; replaces the current music. Throws InputError for
    /// bytes that are no module.
    virtual void play_music(std::span<const std::uint8_t> module_file, std::int32_t volume_256) = 0;
    virtual void set_music_volume(std::int32_t volume_256) = 0;
    virtual void stop_music() = 0;
};

/// Opens a SoundOutput; throws std::runtime_error if there is no device.
using OpenSound = std::function<std::unique_ptr<SoundOutput>()>;

}  // namespace oblong

#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "engine/platform/sound.h"

namespace oblong {

/// Mixes voices for a slow machine: one channel of 8 bits, a tenth of a Mixer's work. Without music. The output device
/// calls mix() for samples, perhaps in an interrupt.
class SmallMixer : public SoundOutput {
  public:
    static constexpr std::int32_t kRate_hz = 11'025, kVoices = 16;
    static constexpr std::uint8_t kSilence = 128;
    using Recordings = std::vector<std::vector<std::int8_t>>;

    SoundNumber add_sound(std::span<const std::int16_t> samples, std::int32_t rate_hz) override;
    VoiceNumber start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) override;
    bool is_playing(VoiceNumber voice) const override;
    void adjust(VoiceNumber voice, const VoiceLevels& levels) override;
    void stop(VoiceNumber voice) override;
    void hold_voices(bool are_held) override;
    void play_music(std::span<const std::uint8_t>, std::int32_t) override {}
    void set_music_volume(std::int32_t) override {}
    void stop_music() override {}

    /// Writes the next samples. False: voices are being changed, and nothing was written.
    bool mix(std::span<std::uint8_t> samples);

    /// A sound at kRate_hz: each sample is the mean of those that it replaces.
    static std::vector<std::int8_t> at_own_rate(std::span<const std::int16_t> samples, std::int32_t rate_hz);

  protected:
    Recordings recordings_;

  private:
    struct Voice {
        VoiceNumber number = kNoVoice;  // kNoVoice: unused
        std::size_t recording = 0, at = 0;
        bool is_loop = false, is_held = false, is_stopping = false, is_muffled = false;
        std::int32_t level_256 = 0, wanted_256 = 0, passed_8 = 0;
    };
    static constexpr std::size_t kBlock = 64;  // samples between changes of a level
    using Sums = std::array<std::int32_t, kBlock>;

    Voice* find(VoiceNumber number);
    void add_voice(Voice& voice, std::span<std::int32_t> sums) const;

    mutable std::mutex mutex_;
    std::array<Voice, kVoices> voices_;
    VoiceNumber next_voice_ = 0;
};

}  // namespace oblong

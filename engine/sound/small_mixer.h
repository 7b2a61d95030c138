#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/sound/voices.h"

namespace oblong {

/// A voice of a SmallMixer.
struct SmallVoice {
    SoundOutput::VoiceNumber number = SoundOutput::kNoVoice;
    std::size_t recording = 0, at = 0;
    bool is_loop = false, is_held = false, is_stopping = false, is_muffled = false;
    std::int32_t level_256 = 0, wanted_256 = 0, passed_8 = 0;

    void set(const VoiceLevels& levels);
    void fade_out() { wanted_256 = 0; }
};

/// Mixes voices for a slow machine: one channel of 8 bits, a tenth of a Mixer's work. Without music. The output device
/// calls mix() for samples, perhaps in an interrupt.
class SmallMixer : public MixerOfVoices<SmallVoice, 16> {
  public:
    static constexpr std::int32_t kRate_hz = 11'025;
    static constexpr std::uint8_t kSilence = 128;
    using Recordings = std::vector<std::vector<std::int8_t>>;

    SoundNumber add_sound(std::span<const std::int16_t> samples, std::int32_t rate_hz) override;
    VoiceNumber start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) override;
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
    static constexpr std::size_t kBlock = 64;  // samples between changes of a level
    using Sums = std::array<std::int32_t, kBlock>;

    void add_voice(SmallVoice& voice, std::span<std::int32_t> sums) const;
};

}  // namespace oblong

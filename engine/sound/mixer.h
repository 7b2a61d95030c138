#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/sound/module_player.h"
#include "engine/sound/voices.h"

namespace oblong {

/// Applies a voice's levels to its samples: the volume on each side, and a low-pass filter if it is muffled. Levels
/// change over some milliseconds.
class VoiceFilter {
  public:
    static constexpr std::int32_t kSides = 2;

    /// Begins a new voice; one that fades in begins silent.
    void begin(const VoiceLevels& levels, bool fades_in);
    /// Sets the levels to move to.
    void set(const VoiceLevels& levels);
    /// Filters samples at 44,100 Hz, left and right alternating.
    void apply(std::span<std::int16_t> samples);
    /// Whether both gains are 0.
    bool is_silent() const { return sides_[0].gain_16 == 0 && sides_[1].gain_16 == 0; }

  private:
    /// A side's current gain, and the states of two low-pass filters in series.
    struct Side {
        std::int32_t gain_16 = 0, first_8 = 0, second_8 = 0;
    };
    std::int16_t filtered(Side& side, std::int16_t sample, std::int32_t cutoff_16) const;

    std::array<std::int32_t, kSides> wanted_256_{};
    bool is_muffled_ = false;
    std::array<Side, kSides> sides_;
    std::int32_t cutoff_16_ = 0;  // the filters' weight of a new sample, 16 fraction bits; 1: no filter
};

/// A voice of a Mixer.
struct MixerVoice {
    SoundOutput::VoiceNumber number = SoundOutput::kNoVoice;
    std::size_t recording = 0;
    bool is_loop = false, is_held = false, is_stopping = false;
    std::uint64_t at_32 = 0;  ///< in the recording, 32 fraction bits
    VoiceFilter filter;

    void set(const VoiceLevels& levels) { filter.set(levels); }
    void fade_out() { filter.set({}); }
};

/// Mixes voices and music with integers: the same calls give the same samples on every machine. The output device calls
/// mix() for them, perhaps in another thread.
class Mixer : public MixerOfVoices<MixerVoice, 32> {
  public:
    static constexpr std::int32_t kRate_hz = ModulePlayer::kRate_hz;

    SoundNumber add_sound(std::span<const std::int16_t> samples, std::int32_t rate_hz) override;
    VoiceNumber start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) override;
    void play_music(std::span<const std::uint8_t> module_file, std::int32_t volume_256) override;
    void set_music_volume(std::int32_t volume_256) override;
    void stop_music() override;

    /// Writes the next samples, left and right alternating.
    void mix(std::span<std::int16_t> samples);

  private:
    struct Recording {
        std::vector<std::int16_t> samples;
        std::int32_t rate_hz = kRate_hz;
    };

    void add_voice(MixerVoice& voice, std::span<std::int32_t> sums) const;

    std::vector<Recording> recordings_;
    std::unique_ptr<ModulePlayer> music_;
    std::int32_t music_volume_256_ = 0;
};

}  // namespace oblong

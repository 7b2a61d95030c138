#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "engine/platform/module_player.h"
#include "engine/platform/sound.h"

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

/// Mixes voices and music with integers: the same calls give the same samples on every machine. The output device calls
/// mix() for them, perhaps in another thread.
class Mixer : public SoundOutput {
  public:
    static constexpr std::int32_t kRate_hz = ModulePlayer::kRate_hz, kVoices = 32;

    SoundNumber add_sound(std::span<const std::int16_t> samples, std::int32_t rate_hz) override;
    VoiceNumber start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) override;
    bool is_playing(VoiceNumber voice) const override;
    void adjust(VoiceNumber voice, const VoiceLevels& levels) override;
    void stop(VoiceNumber voice) override;
    void hold_voices(bool are_held) override;
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
    struct Voice {
        VoiceNumber number = kNoVoice;  // kNoVoice: unused
        std::size_t recording = 0;
        bool is_loop = false, is_held = false, is_stopping = false;
        std::uint64_t at_32 = 0;  // in the recording, 32 fraction bits
        VoiceFilter filter;
    };

    Voice* find(VoiceNumber number);
    void add_voice(Voice& voice, std::span<std::int32_t> sums) const;

    mutable std::mutex mutex_;
    std::vector<Recording> recordings_;
    std::array<Voice, kVoices> voices_;
    VoiceNumber next_voice_ = 0;
    std::unique_ptr<ModulePlayer> music_;
    std::int32_t music_volume_256_ = 0;
};

}  // namespace oblong

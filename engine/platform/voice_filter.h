#pragma once

#include <array>
#include <cstdint>
#include <span>

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

}  // namespace oblong

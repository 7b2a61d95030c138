#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/platform/sound.h"

namespace oblong {

/// Brings the samples of a voice to its levels: how loud on each side, and without the high frequencies where it is
/// muffled. Levels change over some milliseconds.
class VoiceFilter {
  public:
    static constexpr std::int32_t kSides = 2;

    /// Begins a new voice; one that fades in begins silent.
    void begin(const VoiceLevels& levels, bool fades_in);
    /// Where the levels go from now on.
    void set(const VoiceLevels& levels);
    /// Changes samples at 44,100 Hz, left and right by turns.
    void apply(std::span<std::int16_t> samples);
    /// Whether it has gone to silence.
    bool is_silent() const { return sides_[0].gain_16 == 0 && sides_[1].gain_16 == 0; }

  private:
    /// Of a side: its gain now, and two low-pass filters in a row.
    struct Side {
        std::int32_t gain_16 = 0, first_8 = 0, second_8 = 0;
    };
    std::int16_t filtered(Side& side, std::int16_t sample, std::int32_t cutoff_16) const;

    std::array<std::int32_t, kSides> wanted_256_{};
    bool is_muffled_ = false;
    std::array<Side, kSides> sides_;
    std::int32_t cutoff_16_ = 0;  // the filters' share of a new sample, 16 fraction bits; all of it: no filter
};

}  // namespace oblong

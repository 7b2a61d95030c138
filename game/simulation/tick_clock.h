#pragma once

#include <cstdint>

#include "game/simulation/tick_input.h"

namespace oblong {

/// Turns elapsed time into ticks. Times are summed exactly (in 1/3,500 us), so that the same time gives the same number
/// of ticks, however it is divided. In slow motion the same ticks come later.
class TickClock {
  public:
    /// The longest time that counts between two calls: the pause of a suspended machine is not simulated.
    static constexpr std::uint64_t kLongestPause_us = 250'000;

    /// Advances the clock; returns the number of ticks that became due. Negative time counts as 0. `speed_100`: game
    /// time per elapsed time, in hundredths, up to 10,000.
    int advance(std::uint64_t elapsed_us, std::int32_t speed_100 = 100) {
        if (elapsed_us > kLongestPause_us) elapsed_us = elapsed_us >> 63 ? 0 : kLongestPause_us;
        rest_ += static_cast<std::int64_t>(elapsed_us) * kTicksPerSecond * speed_100;
        const std::int64_t due = rest_ / kTick;
        rest_ -= due * kTick;
        return static_cast<int>(due);
    }

    /// The picture's time between the last two ticks, in 65,536ths, 0 to 65,535.
    std::int32_t fraction_16() const { return static_cast<std::int32_t>(rest_ * 65'536 / kTick); }

  private:
    static constexpr std::int64_t kTick = 100 * 1'000'000;  // us * 35 * 100
    std::int64_t rest_ = 0;                                 // the remainder, below one tick
};

}  // namespace oblong

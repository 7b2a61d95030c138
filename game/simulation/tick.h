#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "game/simulation/view_dials.h"

namespace oblong {

/// The rate of the simulation; frames are drawn at any rate.
inline constexpr std::int64_t kTicksPerSecond = 35;

/// The player's input for one tick. A demo is an array of these.
struct TickInput {
    std::int8_t forward = 0;   ///< -127 to 127: 127ths of full speed, forward positive
    std::int8_t right = 0;     ///< likewise, to the right positive
    std::int16_t yaw = 0;      ///< turn in this tick, 65,536 to the circle, to the left positive
    std::int16_t pitch = 0;    ///< likewise, down positive
    std::uint8_t buttons = 0;  ///< the buttons below; other bits are 0
    ViewDials view = kUsualView;
    std::uint16_t work =
        0;  ///< of the picture before: thousands of a 486's cycles, where asks_for_work(); 0: not counted

    bool operator==(const TickInput&) const = default;
};

inline constexpr std::uint8_t kJumpButton = 1;
inline constexpr std::uint8_t kRespawnButton = 2;  ///< back to Progress::respawn
inline constexpr std::uint8_t kVisitButton = 4;    ///< activates GameLevel::visit

/// What a tick did, and what exceeded its bounds. The bounds are counts of operations, never times, so that every build
/// leaves the same work for later.
struct TickReport {
    std::int32_t activations = 0;               ///< entities activated or removed, doors opened, messages shown
    std::int32_t mover_steps = 0;               ///< movers stepped, and obstacles that each tested against the player
    std::int32_t touches = 0;                   ///< touch boxes, triggers and items that the player was in
    std::vector<std::uint32_t> fired_triggers;  ///< into GameLevel::triggers, in their order, perhaps repeatedly

    // True: some were beyond the bounds.
    bool has_left_activations = false;  ///< they wait in Backlog::waiting
    bool has_dropped_firings = false;   ///< too many waited already
    bool has_left_movers = false;       ///< they stand still for some ticks
    bool has_left_touches = false;      ///< they count in a later tick
    bool has_left_obstacles = false;    ///< brush models in one place that are not solid

    // The bounds of a tick. The last activation or mover may exceed its bound by its own count.
    static constexpr std::int32_t kMostWaitingActivations = 8192;  ///< of the backlog
    static constexpr std::int32_t kMostDelayedActivations = 8192;
    static constexpr std::int32_t kMostNewActivations = 24'576;
    static constexpr std::int32_t kMostMoverSteps = 8192;
    static constexpr std::int32_t kMostTeleports = 16;

    /// A warning for each kind of work that was left; empty if none was.
    std::vector<std::string_view> left() const;
};

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

#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace oblong {

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

}  // namespace oblong

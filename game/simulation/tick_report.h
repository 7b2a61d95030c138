#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace oblong {

/// What a tick did, and what of it was too much for one tick. A tick's work is bounded by counts of operations, never
/// by time, so that every build leaves the same for later.
struct TickReport {
    std::int32_t activations = 0;               ///< entities activated or removed, doors opened, messages shown
    std::int32_t mover_steps = 0;               ///< movers stepped, and what each looked at that met the player
    std::int32_t touches = 0;                   ///< touch boxes, triggers and items that the player was in
    std::vector<std::uint32_t> fired_triggers;  ///< into GameLevel::triggers, in their order, perhaps repeatedly

    // True: there were more.
    bool has_left_activations = false;  ///< they wait in Backlog::waiting
    bool has_dropped_firings = false;   ///< too many waited already
    bool has_left_movers = false;       ///< they stand still for some ticks
    bool has_left_touches = false;      ///< they count in a later tick
    bool has_left_obstacles = false;    ///< brush models in one place that are not solid

    // The most of each in a tick. Activations and movers may exceed theirs by what one of them counts.
    static constexpr std::int32_t kMostWaitingActivations = 8192;  ///< of the backlog
    static constexpr std::int32_t kMostDelayedActivations = 8192;
    static constexpr std::int32_t kMostNewActivations = 24'576;
    static constexpr std::int32_t kMostMoverSteps = 8192;
    static constexpr std::int32_t kMostTeleports = 16;

    /// What was left, each kind in words for a warning; empty if nothing was.
    std::vector<std::string_view> left() const;
};

}  // namespace oblong

#pragma once

#include <cstdint>

namespace oblong {

/// The rate of the simulation; frames are drawn at any rate.
inline constexpr std::int64_t kTicksPerSecond = 35;

/// The player's input for one tick. A demo is an array of these.
struct TickInput {
    std::int8_t forward = 0;   ///< -127 to 127: 127ths of full speed, forward positive
    std::int8_t right = 0;     ///< likewise, to the right positive
    std::int16_t yaw = 0;      ///< turn in this tick, 65,536 to the circle, to the left positive
    std::int16_t pitch = 0;    ///< likewise, down positive
    std::uint8_t buttons = 0;  ///< kJumpButton, kRespawnButton; other bits are 0

    bool operator==(const TickInput&) const = default;
};

inline constexpr std::uint8_t kJumpButton = 1;
inline constexpr std::uint8_t kRespawnButton = 2;  ///< back to Progress::respawn

}  // namespace oblong

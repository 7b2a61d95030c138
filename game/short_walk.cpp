#include "game/short_walk.h"

namespace oblong {

// In ticks: 2.5 s ahead, a quarter turn to the right, 4 s ahead with a jump, a turn to the left.
Controls short_walk(std::int64_t tick) {
    constexpr std::int64_t kTurn = 87, kAhead = 110, kJump = 130, kLook = 250, kRound = 280;
    const std::int64_t at = tick % kRound;
    Controls controls;
    controls.forward = at < kTurn || (at >= kAhead && at < kLook);
    controls.turn_right = at >= kTurn && at < kAhead;
    controls.turn_left = at >= kLook;
    controls.jump = at == kJump;
    return controls;
}

}  // namespace oblong

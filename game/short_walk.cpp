#include "game/short_walk.h"

#include "game/tick_input.h"

namespace oblong {

Controls short_walk(std::int64_t tick) {
    constexpr std::int64_t kRound = 6 * kTicksPerSecond;
    const std::int64_t at = tick % kRound;
    const auto is_during = [&](std::int64_t from_s, std::int64_t to_s) {
        return at >= from_s * kTicksPerSecond && at < to_s * kTicksPerSecond;
    };
    Controls controls;
    controls.forward = is_during(0, 2) || is_during(3, 5);
    controls.turn_left = is_during(2, 3);
    controls.turn_right = is_during(5, 6) && (tick / kRound) % 2 == 1;
    controls.jump = at == 4 * kTicksPerSecond;
    return controls;
}

}  // namespace oblong

#pragma once

#include <cstdint>
#include <string>

#include "engine/frame/frame.h"
#include "game/level/load.h"
#include "game/simulation/demo.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// The drawing times of a demo's frames, one a tick, without ticks and reading.
struct TimedemoResult {
    std::int64_t frames = 0;
    std::int64_t total_us = 0, median_us = 0;
};

/// Draws each tick of a demo. Throws InputError if the demo was recorded on another level.
TimedemoResult run_timedemo(const LoadedLevel& loaded, Demo demo, GameRenderer& renderer, const Settings& settings,
                            Degrees field_of_view);

/// "123 frames, 0.456 seconds, 269.7 frames a second, median 3700 microseconds".
std::string describe(const TimedemoResult& result);

}  // namespace oblong

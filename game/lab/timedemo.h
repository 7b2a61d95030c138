#pragma once

#include <string>

#include "game/level/load.h"
#include "game/simulation/demo.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// Draws each tick of a demo, and times the drawing alone: "123 frames, 0.456 seconds, 269.7 frames a second, median
/// 3700 microseconds". Throws InputError if the demo was recorded on another level.
std::string run_timedemo(const LoadedLevel& loaded, Demo demo, GameRenderer& renderer, const Settings& settings,
                         Degrees field_of_view);

}  // namespace oblong

#pragma once

#include <cstdint>
#include <vector>

namespace oblong {

/// What a key asks of the program, once for each press.
enum class Command {
    ShowHelp,          ///< F1
    ProjectionAspect,  ///< F2
    DisplayAspect,     ///< F3
    AccuracyTier,      ///< F4
    ScalingMode,       ///< F5
    FrameCost,         ///< F6
    Screenshot,        ///< F12
};

/// What the player's hands do between two polls: keys held now, and what has moved or been pressed since.
struct Controls {
    bool forward = false, back = false, left = false, right = false;  ///< walk
    bool turn_left = false, turn_right = false, look_up = false, look_down = false;
    bool jump = false, walk_slowly = false;
    std::int32_t mouse_x = 0, mouse_y = 0;  ///< counts of the device, right and down positive
    std::vector<Command> commands;
};

}  // namespace oblong

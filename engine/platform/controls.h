#pragma once

#include <cstdint>
#include <vector>

namespace oblong {

/// A command key, reported once for each press.
enum class Command {
    ShowHelp,          ///< F1
    ProjectionAspect,  ///< F2
    DisplayAspect,     ///< F3
    AccuracyTier,      ///< F4
    ScalingMode,       ///< F5
    FrameCost,         ///< F6
    Screenshot,        ///< F12
};

/// The player's input between two polls: keys held now, mouse motion and presses since the last poll.
struct Controls {
    bool forward = false, back = false, left = false, right = false;  ///< walk
    bool turn_left = false, turn_right = false, look_up = false, look_down = false;
    bool jump = false, walk_slowly = false;
    std::int32_t mouse_x = 0, mouse_y = 0;  ///< counts of the device, right and down positive
    std::vector<Command> commands;
};

}  // namespace oblong

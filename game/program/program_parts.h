#pragma once

#include <functional>
#include <memory>

#include "engine/platform/platform.h"
#include "game/lab/error_meter.h"
#include "game/level/load.h"
#include "game/program/game_screen.h"
#include "game/program/view_options.h"
#include "game/sound/game_sound.h"

namespace oblong {

/// Makes the screen of the gallery over the museum's level. `view_options`, which keys change, and `platform` outlive
/// it.
using OpenGallery = std::unique_ptr<GameScreen> (*)(std::shared_ptr<const LoadedLevel> museum,
                                                    ViewOptions& view_options, Platform& platform);

/// What a system has for the game beside its Platform; each may be empty.
struct ProgramParts {
    Workers* workers = nullptr;  ///< that share the drawing; null: one thread
    OpenSound open_sound = {};
    OpenErrorMeter open_meter = nullptr;
    OpenGallery open_gallery = nullptr;
    /// Where the gallery is another program: starts it. Throws FileError.
    std::function<void()> start_gallery = {};
};

}  // namespace oblong

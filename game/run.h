#pragma once

#include <string>

#include "game/options.h"

namespace oblong {

/// Plays as the options ask: in a window, without one, or a timed demo. Throws FileError, or std::runtime_error where
/// there is no display.
void run_game(const Options& options, const std::string& assets_folder);

}  // namespace oblong

#pragma once

#include <memory>

#include "engine/platform/platform.h"
#include "engine/sound/sound.h"

namespace oblong {

/// Opens a window of `size` pixels (0x0: the largest whole multiple of 320x240 with room on the desktop), and the
/// user's keyboard and mouse with it. Throws std::runtime_error with SDL's message if there is no display.
std::unique_ptr<Platform> open_window(const char* title, WindowSize size);

/// Opens the user's audio device with a Mixer. Throws std::runtime_error with SDL's message if there is none. A device
/// that is lost later becomes silent.
std::unique_ptr<SoundOutput> open_mixer();

}  // namespace oblong

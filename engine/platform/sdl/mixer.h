#pragma once

#include <memory>

#include "engine/platform/sound.h"

namespace oblong {

/// Opens the user's audio device with SDL_mixer. Throws std::runtime_error with SDL's message where there is none. A
/// device that is lost later only becomes silent.
std::unique_ptr<SoundOutput> open_mixer();

}  // namespace oblong

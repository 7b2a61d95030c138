#pragma once

#include <memory>

#include "engine/platform/platform.h"
#include "engine/platform/sound.h"

namespace oblong {

/// A web page's canvas, and its user's keyboard, mouse, gamepads and touches. page.js, which loaded the program, does
/// what only the browser can.
/// With `waits`, present() ends with the browser's next picture: for programs that load.js enters and leaves there.
std::unique_ptr<Platform> open_page(bool waits = false);

/// The browser's sound, silent until the first key or click: browsers want that. Throws std::runtime_error where there
/// is none.
std::unique_ptr<SoundOutput> open_page_sound();

}  // namespace oblong

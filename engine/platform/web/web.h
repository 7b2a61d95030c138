#pragma once

#include <memory>

#include "engine/platform/platform.h"
#include "engine/sound/sound.h"

namespace oblong {

/// A web page's canvas, and its user's keyboard, mouse, gamepads and touches. page.js, which loaded the program, does
/// the part that needs the browser.
std::unique_ptr<Platform> open_page(bool waits = false);

/// The browser's sound, silent until the first key or click, as browsers require. Throws std::runtime_error if there is
/// none.
std::unique_ptr<SoundOutput> open_page_sound();

}  // namespace oblong

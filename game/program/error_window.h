#pragma once

#include <string>

namespace oblong {

/// Shows an error in a window until the user closes it or presses Enter, Esc or the mouse: a player who started the
/// game from a menu does not see standard error. Drawn with the game's own letters, since SDL's message boxes need
/// fonts or programs that some desktops lack. Does nothing without a display.
void show_error_window(const std::string& text);

}  // namespace oblong

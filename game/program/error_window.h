#pragma once

#include <string>

namespace oblong {

/// Shows an error in a window of its own until the user closes it or presses Enter, Esc or the mouse: for who reads no
/// standard error. By the game's own letters: SDL's message boxes need fonts or programs that not every desktop has.
/// Does nothing where there is no display.
void show_error_window(const std::string& text);

}  // namespace oblong

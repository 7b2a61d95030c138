#pragma once

#include <string>

namespace oblong {

/// Shows an error in a window of its own until the user closes it. Nothing happens where there is no display.
void show_error_box(const std::string& title, const std::string& text);

}  // namespace oblong

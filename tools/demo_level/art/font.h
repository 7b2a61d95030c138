#pragma once

#include <string_view>

#include "tools/demo_level/art/canvas.h"

namespace oblong::art {

/// Capital letters, digits, space and a few signs of 5x7 texels, `scale` times as large, a gap of one texel (scaled)
/// between them.
int text_width(std::string_view text, int scale);
void draw_text(Canvas& canvas, std::string_view text, int x, int y, int scale, Texel texel);

}  // namespace oblong::art

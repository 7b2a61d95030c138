#pragma once

#include <string_view>

#include "tools/demo_level/art/canvas.h"

namespace oblong::art {

/// A brass-framed plate of 128x32 with a room's title engraved in gold on night blue; two lines if `second` is given.
Canvas paint_sign(std::string_view first, std::string_view second = "");
/// 128x32 in large letters that glow.
Canvas paint_title(std::string_view text);
/// 64x32, a glowing arrow with EXIT; `frame` 0 or 1 of its animation.
Canvas paint_exit_sign(int frame);

/// Pictures of 64x64 in gilt frames.
Canvas paint_picture_road();   ///< a road to its vanishing point
Canvas paint_picture_cubes();  ///< an isometric pile
Canvas paint_picture_eye();    ///< eye, picture plane and object
Canvas paint_picture_moon();   ///< a round moon over water

}  // namespace oblong::art

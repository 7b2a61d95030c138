#pragma once

#include "tools/demo_level/art/canvas.h"

namespace oblong::art {

Canvas paint_sky();    ///< 256x128: right half the stars far behind, left half clouds, index 0 where they have gaps
Canvas paint_water();  ///< 64x64
Canvas paint_lava();   ///< 64x64, glows
Canvas paint_earth();  ///< 64x64, lawn between paths

}  // namespace oblong::art

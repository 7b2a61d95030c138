#pragma once

#include "tools/demo_level/art/canvas.h"

namespace oblong::art {

Canvas paint_brass_panel();  ///< 64x64, riveted plates
Canvas paint_brass_trim();   ///< 64x16, a moulding
Canvas paint_brass_dial();   ///< 64x64, a plate with a dial and its hand
Canvas paint_iron_grate();   ///< 64x64, a floor of crossed bars
Canvas paint_copper_roof();  ///< 64x64, scales gone green
Canvas paint_lamp();         ///< 32x32, glowing glass in a brass cage
Canvas paint_lamp_blue();    ///< 32x32, the same in blue
Canvas paint_lit_window();   ///< 32x64, a window with light behind it

}  // namespace oblong::art

#pragma once

#include "tools/demo_level/art/canvas.h"

namespace oblong::art {

/// Wood, cloth and plaster, 64x64 but for the door's leaf (64x128).

Canvas paint_wood_planks();
Canvas paint_wood_panel();
Canvas paint_wood_door();
Canvas paint_carpet();
Canvas paint_plaster_night();  ///< deep blue with small gold stars
Canvas paint_plaster(Ramp ramp);
Canvas paint_coffer();      ///< a ceiling's sunken panel with a rosette
Canvas paint_grid_paper();  ///< a draughtsman's squares
Canvas paint_cube_face(Ramp ramp);
Canvas paint_ruler();    ///< thin stripes: what affine texturing cannot hide
Canvas paint_diamond();  ///< 64x64 floor of slanted squares

}  // namespace oblong::art

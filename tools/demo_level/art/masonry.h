#pragma once

#include "tools/demo_level/art/canvas.h"

namespace oblong::art {

/// Walls and floors of stone. All are 64x64 but for the checker, which is 128x128 (four tiles of 64).

Canvas paint_stone_wall();    ///< cool ashlar, the museum's outside
Canvas paint_stone_dark();    ///< rougher and darker: the tower
Canvas paint_stone_floor();   ///< flagstones
Canvas paint_sand_wall();     ///< warm ashlar, the rooms
Canvas paint_sand_frieze();   ///< 64x32, a meander
Canvas paint_brick();         ///< small red bricks
Canvas paint_checker();       ///< black and white marble tiles
Canvas paint_marble_ivory();  ///< columns
Canvas paint_marble_green();  ///< pedestals
Canvas paint_basin_tiles();   ///< small glazed tiles, under water

}  // namespace oblong::art

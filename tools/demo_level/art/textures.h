#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/demo_level/art/canvas.h"

namespace oblong::art {

/// A texture and the name of its file in assets/textures, without ".png".
struct NamedCanvas {
    std::string name;
    Canvas canvas;
};

/// All textures of the demo level.
std::vector<NamedCanvas> paint_all_textures();

Canvas paint_sky();    ///< 256x128: right half the stars far behind, left half clouds, index 0 where they have gaps
Canvas paint_water();  ///< 64x64
Canvas paint_lava();   ///< 64x64, glows
Canvas paint_earth();  ///< 64x64, lawn between paths
Canvas paint_hedge();  ///< 64x64, clipped leaves

Canvas paint_brass_panel();  ///< 64x64, riveted plates
Canvas paint_brass_trim();   ///< 64x16, a moulding
Canvas paint_brass_dial();   ///< 64x64, a plate with a dial and its hand
Canvas paint_iron_grate();   ///< 64x64, a floor of crossed bars
Canvas paint_copper_roof();  ///< 64x64, scales gone green
Canvas paint_lamp();         ///< 32x32, glowing glass in a brass cage
Canvas paint_lamp_blue();    ///< 32x32, the same in blue
Canvas paint_lit_window();   ///< 32x64, a window with light behind it
Canvas paint_grate();        ///< 64x64, bars with holes between them

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

Canvas paint_teleport();  ///< 64x64, a swirl that glows
Canvas paint_mirror();    ///< 64x64, silvered glass where mirrors are not drawn
Canvas paint_lantern();   ///< 32x32, with holes around it
Canvas paint_fern();      ///< 48x64, in a pot, with holes around it
Canvas paint_neon();      ///< 128x32, WORKSHOP among lights in the colours of Ramp::Magenta, which nothing else has
Canvas paint_volt(int frame);  ///< 64x64, a bolt that brightens and fades in kVoltFrames frames
Canvas paint_lamp_dead();      ///< 32x32, the lamp with broken glass
inline constexpr int kVoltFrames = 4;
/// 192x16, a round window of 16 texels for each lens of kLensRamps: of its glass, or dark.
Canvas paint_lens_windows(bool is_lit);

/// A brass-framed plate, as wide as its text needs and 32 high, with a room's title engraved in gold on night blue;
/// 48 high and of two lines if `second` is given.
Canvas paint_sign(std::string_view first, std::string_view second = "");
/// 128x32 in large letters that glow.
Canvas paint_title(std::string_view text);
inline constexpr int kExitFrames = 4;
/// 112x32, EXIT and three arrows that light up one after the other; in the last frame of four none does.
Canvas paint_exit_sign(int frame);

/// Pictures of 64x64 in gilt frames.
Canvas paint_picture_road();   ///< a road to its vanishing point
Canvas paint_picture_cubes();  ///< an isometric pile
Canvas paint_picture_eye();    ///< eye, picture plane and object
Canvas paint_picture_moon();   ///< a round moon over water

}  // namespace oblong::art

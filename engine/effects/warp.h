#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/fixed/angle.h"
#include "engine/raster/kernels/effect_kernels.h"
#include "engine/view/screen.h"

namespace oblong {

/// The warp of liquids repeats after so long: Quake's 20 steps of 128 a second.
inline constexpr std::int64_t kWarpPeriod_ms = 6'400;

/// Warp tables of the four mip levels. As in Quake, u moves by 8 + 8 sin(2 pi (v + 20 t) / 128) texels of mip level 0,
/// and v by the same of u; half of that, over half as many texels, with each further level.
using WarpTables = std::array<WarpTable, 4>;

/// The tables at a time of 0 or more: once a frame, if something in it warps.
WarpTables make_warp_tables(std::int64_t time_ms);

/// The waves of a view under water repeat after so long: Quake's 20 steps of 128 a second.
inline constexpr std::int64_t kUnderwaterPeriod_ms = 6'400;

/// A column or a row of a picture.
struct WavePlace {
    Angle angle;        ///< of the wave along its axis, at a time of 0
    std::int32_t from;  ///< the one that is shown there, but for the waves
};

/// The columns or the rows of a picture.
struct WaveAxis {
    std::int32_t amplitude_px = 0;  ///< by which the waves of the other axis move along this one
    std::int32_t period_px = 0;     ///< after which its waves repeat; the whole axis where that is no whole number
    std::vector<WavePlace> places;
};

/// Neighbouring pixels of a row that show neighbours.
struct WaveRun {
    std::uint32_t from;         ///< the first one's place, from the row that is shown on
    std::int32_t first, count;  ///< columns
};

/// What the underwater pass keeps: of a mode its axes; of a frame a copy of the picture, and how that is moved.
struct UnderwaterScratch {
    WaveAxis across, down;
    std::vector<std::uint8_t> picture;
    std::vector<std::int32_t> shifts;  ///< of columns, then of rows
    std::vector<WaveRun> runs;
};

/// Moves the whole picture in waves, as Quake does: a pixel shows another one, moved along its row by a sine of the row
/// and along its column by a sine of the column: 3 pixels to either side and 128 pixels a wave at 320x200, in
/// proportion in other modes. The picture is shrunk by as much, so that none of it comes from outside. For pictures of
/// 8x8 pixels to 4,096x4,096 and times of 0 or more.
void draw_underwater(std::int64_t time_ms, UnderwaterScratch& scratch, Framebuffer out);

}  // namespace oblong

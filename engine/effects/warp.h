#pragma once

#include <array>
#include <cstdint>
#include <vector>

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

/// What the underwater pass keeps while a frame is drawn: a copy of the picture, and where each column comes from.
/// Neighbouring pixels of a row that show neighbours.
struct WaveRun {
    std::uint32_t from;         ///< the first one's place, from the row that is shown on
    std::int32_t first, count;  ///< columns
};

struct UnderwaterScratch {
    std::vector<std::uint8_t> picture;
    std::vector<WaveRun> runs;
};

/// Moves the whole picture in waves, as Quake does: a pixel shows another one, moved along its row by a sine of the row
/// and along its column by a sine of the column: 3 pixels to either side and 128 pixels a wave at 320x200, in
/// proportion in other modes. The picture is shrunk by as much, so that none of it comes from outside. For pictures of
/// 8x8 pixels to 4,096x4,096 and times of 0 or more.
void draw_underwater(std::int64_t time_ms, UnderwaterScratch& scratch, Framebuffer out);

}  // namespace oblong

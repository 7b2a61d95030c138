#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/fixed/trig.h"
#include "engine/raster/kernels/effect_kernels.h"
#include "engine/view/screen.h"

namespace oblong {

/// The period of the warp of liquids: Quake's 20 of 128 steps a second.
inline constexpr std::int64_t kWarpPeriod_ms = 6'400;

/// Warp tables of the four mip levels. As in Quake, u moves by 8 + 8 sin(2 pi (v + 20 t) / 128) texels of mip level 0,
/// and v by the same function of u; each further level has half the amplitude and half the wavelength.
using WarpTables = std::array<WarpTable, 4>;

/// The tables at time_ms >= 0; made once a frame, if something warps.
WarpTables make_warp_tables(std::int64_t time_ms);

/// The period of the waves of a view under water: Quake's 20 of 128 steps a second.
inline constexpr std::int64_t kUnderwaterPeriod_ms = 6'400;

/// A column or a row of a picture.
struct WavePlace {
    Angle angle;        ///< of the wave along its axis, at time 0
    std::int32_t from;  ///< the column or row shown there without the waves
};

/// The columns or the rows of a picture.
struct WaveAxis {
    std::int32_t amplitude_px = 0;  ///< of the other axis's waves, which move along this one
    std::int32_t period_px = 0;     ///< of its waves; the whole axis if that is not a whole number
    std::vector<WavePlace> places;
};

/// Consecutive pixels of a row that show consecutive pixels.
struct WaveRun {
    std::uint32_t from;         ///< offset of the first one's source
    std::int32_t first, count;  ///< columns
};

/// Scratch of the underwater pass: the axes of a mode, and for a frame a copy of the picture and its shifts.
struct UnderwaterScratch {
    WaveAxis across, down;
    std::vector<std::uint8_t> picture;
    std::vector<std::int32_t> shifts;  ///< of columns, then of rows
    std::vector<WaveRun> runs;
};

/// Moves the whole picture in waves, as in Quake: a pixel is shifted along its row by a sine of the row, and along its
/// column by a sine of the column. At 320x200 the amplitude is 3 pixels and the wavelength 128, in proportion in other
/// modes. The picture is shrunk so that no pixel comes from outside. For pictures of 8x8 to 4,096x4,096 pixels; time_ms
/// >= 0.
void draw_underwater(std::int64_t time_ms, UnderwaterScratch& scratch, Framebuffer out);

}  // namespace oblong

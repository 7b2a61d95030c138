#pragma once

#include <array>
#include <cstdint>

#include "engine/raster/kernels/effect_kernels.h"

namespace oblong {

/// The warp of liquids repeats after so long: Quake's 20 steps of 128 a second.
inline constexpr std::int64_t kWarpPeriod_ms = 6'400;

/// Warp tables of the four mip levels. As in Quake, u moves by 8 + 8 sin(2 pi (v + 20 t) / 128) texels of mip level 0,
/// and v by the same of u; half of that, over half as many texels, with each further level.
using WarpTables = std::array<WarpTable, 4>;

/// The tables at a time of 0 or more: once a frame, if something in it warps.
WarpTables make_warp_tables(std::int64_t time_ms);

}  // namespace oblong

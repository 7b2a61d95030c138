#pragma once

#include <cstdint>
#include <vector>

#include "engine/surface/palette.h"

namespace oblong {

inline constexpr std::int32_t kRampCellWidth_px = 8, kRampCellHeight_px = 4;

/// The PNG of a palette's colormap: a row of cells for each of the 256 colours, its shades from the brightest on the
/// left to the darkest on the right.
std::vector<std::uint8_t> make_ramp_sheet(const Palette& palette);

}  // namespace oblong

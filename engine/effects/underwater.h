#pragma once

#include <cstdint>
#include <vector>

#include "engine/view/screen.h"

namespace oblong {

/// The waves of a view under water repeat after so long: Quake's 20 steps of 128 a second.
inline constexpr std::int64_t kUnderwaterPeriod_ms = 6'400;

/// What the underwater pass keeps while a frame is drawn: a copy of the picture, and where each column comes from.
struct UnderwaterScratch {
    std::vector<std::uint8_t> picture;
    std::vector<std::uint32_t> columns;
};

/// Moves the whole picture in waves, as Quake does: a pixel shows another one, moved along its row by a sine of the row
/// and along its column by a sine of the column: 3 pixels to either side and 128 pixels a wave at 320x200, in
/// proportion in other modes. The picture is shrunk by as much, so that none of it comes from outside. For pictures of
/// 8x8 pixels to 4,096x4,096 and times of 0 or more.
void draw_underwater(std::int64_t time_ms, UnderwaterScratch& scratch, Framebuffer out);

}  // namespace oblong

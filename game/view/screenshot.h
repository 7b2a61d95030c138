#pragma once

#include <string>

#include "engine/surface/palette.h"
#include "engine/view/screen.h"

namespace oblong {

/// Writes the picture in its own size and in one that shows the mode in its right shape with whole multiples of pixels,
/// the largest up to 1600x1200, or else the smallest, unless that has a side of more than 8,192: as indexed PNGs
/// "oblong-000.png" and "oblong-000-1600x1200.png" of the first free number, into the current folder. Returns a message
/// to the player, also on failure, for KeyNames::in().
std::string save_screenshots(Framebuffer picture, const Palette& palette, const ScreenMode& mode);

}  // namespace oblong

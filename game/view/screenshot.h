#pragma once

#include <string>

#include "engine/surface/palette.h"
#include "engine/view/present_rect.h"
#include "engine/view/screen.h"

namespace oblong {

/// The size of a picture that shows the mode in its right shape with whole multiples of pixels: 1600x1200 for 320x200
/// on 4:3. The largest up to 1600x1200, or else the smallest; 0x0 if that has a side of more than 8,192.
WindowSize exact_size(const ScreenMode& mode);

/// Writes the picture in its own and in its exact size, as indexed PNGs "oblong-000.png" and "oblong-000-1600x1200.png"
/// of the first free number, into the current folder. Returns a message to the player, also on failure, for
/// KeyNames::in().
std::string save_screenshots(Framebuffer picture, const Palette& palette, const ScreenMode& mode);

}  // namespace oblong

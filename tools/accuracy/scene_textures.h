#pragma once

#include <string>

#include "engine/surface/palette.h"

namespace oblong {

/// The bytes of a WAD with the hard scenes' textures, `stone` and `tiles`: grain and joints of high contrast, so that a
/// texel out of place shows.
std::string make_scene_wad(const Palette& palette);

}  // namespace oblong

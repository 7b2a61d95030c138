#pragma once

#include <string>
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

}  // namespace oblong::art

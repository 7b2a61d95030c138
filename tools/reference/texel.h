#pragma once

#include <array>

#include "tools/reference/projection.h"

namespace oblong::reference {

struct TexturedCorner {
    Vec position;
    double u = 0, v = 0;
};

struct Texel {
    double u = 0, v = 0, inverse_z = 0;
};

/// What the plane of a triangle shows at a place on the screen, by barycentric weights of the ray through it.
Texel texel_at(const std::array<TexturedCorner, 3>& corners, const Projection& projection, ScreenPoint at);

}  // namespace oblong::reference

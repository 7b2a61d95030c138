#include "tools/reference/texel.h"

namespace oblong::reference {

Texel texel_at(const std::array<TexturedCorner, 3>& corners, const Projection& projection, ScreenPoint at) {
    const Vec ray{(at.x - projection.width_px / 2) / projection.multiplier_x,
                  (projection.height_px / 2 - at.y) / projection.multiplier_y, 1};
    const Vec &a = corners[0].position, &b = corners[1].position, &c = corners[2].position;
    const double weights[] = {dot(cross(b, c), ray), dot(cross(c, a), ray), dot(cross(a, b), ray)};
    const double sum = weights[0] + weights[1] + weights[2];
    Texel texel{0, 0, sum / dot(a, cross(b, c))};
    for (std::size_t i = 0; i < 3; ++i) {
        texel.u += weights[i] * corners[i].u / sum;
        texel.v += weights[i] * corners[i].v / sum;
    }
    return texel;
}

}  // namespace oblong::reference

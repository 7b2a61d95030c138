#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/math/vec.h"
#include "engine/view/gradients.h"
#include "engine/view/projection.h"

namespace oblong {

/// A corner of a triangle in viewspace, and the texel that it shows.
struct TexturedCorner {
    Vec3<Fixed<std::int32_t, 14>> position;  ///< within 2^15 units of the eye along each axis
    Texel u, v;                              ///< from 0 to 65,536
};

/// The screen gradients of 1/z, u/z and v/z of a triangle. At the centre of `anchor` they are within half a step of
/// their formats, and each column or row away from it adds half a step: so spans anchored in their middle are accurate
/// anywhere in any mode. None for a triangle that is seen edge-on.
///
/// With corners A, B, C, N = A x B + B x C + C x A and D = A . (B x C), the point seen along P = (X, Y, 1) has
///     1/z = N . P / D,    u/z = (uA (B x C) + uB (C x A) + uC (A x B)) . P / D.
/// Determinants are exact; the rest has 62 significant bits.
std::optional<TextureGradients> make_triangle_gradients(const std::array<TexturedCorner, 3>& corners,
                                                        const Projection& projection, PixelPosition anchor);

}  // namespace oblong

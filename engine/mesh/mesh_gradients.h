#pragma once

#include <array>
#include <optional>

#include "engine/mesh/mesh_stages.h"
#include "engine/screen/gradients.h"

namespace oblong {

/// What goes linearly over the screen, of a triangle.
struct MeshGradients {
    TextureGradients texture;                       ///< 1/z, u/z, v/z
    LinearQuantity<Fixed<std::int64_t, 32>> light;  ///< CornerValues::light
    Vec3<LinearQuantity<Fixed<std::int64_t, 30>>> normal;
};

/// What of it is wanted.
struct GradientChoice {
    bool has_normal = false;  ///< Shading::Phong
    bool is_affine = false;   ///< u/z and v/z are u and v themselves: no perspective
};

/// A triangle on the screen, and what changes over it.
struct ShadedTriangle {
    std::array<ScreenVertex, 3> corners;
    MeshGradients gradients;
};

/// The gradients of a triangle from its corners as they were rounded to the screen: barycentric coordinates are
///     b = ((x - xA) (yC - yA) - (y - yA) (xC - xA)) / area,    c = ((y - yA) (xB - xA) - (x - xA) (yB - yA)) / area,
/// linear in x and y, and each quantity is A's + b (B's - A's) + c (C's - A's). So what a pixel gets whose centre is
/// inside lies between what the corners have, however thin or steep the triangle is. One that is thinner than 1/16
/// pixel changes along its longest side alone. None for a triangle without area, or seen from its back.
std::optional<ShadedTriangle> make_shaded_triangle(const std::array<const ScreenCorner*, 3>& corners,
                                                   const GradientChoice& choice);

}  // namespace oblong

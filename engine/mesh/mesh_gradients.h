#pragma once

#include <array>
#include <optional>

#include "engine/mesh/mesh_stages.h"
#include "engine/view/gradients.h"

namespace oblong {

/// What goes linearly over the screen, of a triangle.
struct MeshGradients {
    TextureGradients texture;                       ///< 1/z, u/z, v/z
    LinearQuantity<Fixed<std::int64_t, 32>> light;  ///< CornerValues::light
    Vec3<LinearQuantity<Fixed<std::int64_t, 30>>> normal;
};

/// A barycentric coordinate's change per pixel: at most 16.
using WeightStep = Fixed<std::int64_t, 48>;

/// Barycentric coordinates of two corners, seen from the first one, and how they change.
struct Barycentric {
    std::array<const ScreenCorner*, 3> corners;
    WeightStep b_per_column, b_per_row, c_per_column, c_per_row;

    const ScreenVertex& anchor() const { return corners[0]->screen; }
};

/// What of it is wanted.
struct GradientChoice {
    bool has_normal = false;  ///< Shading::Phong
    bool is_affine = false;   ///< u/z and v/z are u and v themselves: no perspective
};

/// The barycentric coordinates of a triangle from its corners as they were rounded to the screen:
///     b = ((x - xA) (yC - yA) - (y - yA) (xC - xA)) / area,    c = ((y - yA) (xB - xA) - (x - xA) (yB - yA)) / area,
/// linear in x and y, and each quantity is A's + b (B's - A's) + c (C's - A's). So what a pixel gets whose centre is
/// inside lies between what the corners have, however thin or steep the triangle is. One that is thinner than 1/16
/// pixel changes along its longest side alone. None for a triangle without area, or seen from its back. The corners'
/// values are not read yet.
std::optional<Barycentric> make_barycentric(const std::array<const ScreenCorner*, 3>& corners);

/// 1/z over the screen.
LinearQuantity<InverseZ> inverse_z_over(const Barycentric& weights);

/// All gradients: 1/z is the one above.
MeshGradients make_mesh_gradients(const Barycentric& weights, const LinearQuantity<InverseZ>& inverse_z,
                                  const GradientChoice& choice);

}  // namespace oblong

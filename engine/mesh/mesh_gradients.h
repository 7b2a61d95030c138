#pragma once

#include <array>

#include "engine/mesh/mesh_stages.h"
#include "engine/view/gradients.h"

namespace oblong {

/// The quantities of a triangle that are linear over the screen, counted from a pixel of its own.
struct MeshGradients {
    std::int32_t first_column = 0, first_row = 0;
    TextureGradients texture;                       ///< 1/z, u/z, v/z
    LinearQuantity<Fixed<std::int64_t, 32>> light;  ///< CornerValues::light
    Vec3<LinearQuantity<Fixed<std::int64_t, 30>>> normal;
};

/// Change of a barycentric coordinate per pixel, at most 16.
using WeightStep = Fixed<std::int64_t, 48>;

/// A WeightStep as high * 2^32 + low, both with a sign: times 32 bits it is two products and their sum.
struct StoredStep {
    std::int32_t low = 0, high = 0;

    StoredStep() = default;
    StoredStep(WeightStep step)
        : low(static_cast<std::int32_t>(step.raw)), high(static_cast<std::int32_t>((step.raw - low) >> 32)) {}
    operator WeightStep() const { return WeightStep::from_raw(high * (std::int64_t{1} << 32) + low); }
};

/// A barycentric coordinate at a pixel, 0 to 1.
using PixelWeight = Fixed<std::int32_t, 30>;

/// The barycentric coordinates b and c of a triangle's second and third corner over the screen; both are 0 at the
/// first.
struct Barycentric {
    std::array<const ScreenPlace*, 3> corners;
    std::array<std::uint8_t, 3> order;  ///< the corners' numbers in the triangle
    StoredStep b_per_column, b_per_row, c_per_column, c_per_row;
    std::int32_t first_column = 0, first_row = 0;  ///< the pixel from which quantities count: most triangles have few
    bool has_one_pixel = false;                    ///< that pixel; of all others only `b` and `c` are set then
    PixelWeight b, c;                              ///< there

    const ScreenVertex& anchor() const { return corners[0]->screen; }
};

/// Which gradients to compute, and how.
struct GradientChoice {
    bool has_normal = false;  ///< Shading::Phong
    bool is_affine = false;   ///< u/z and v/z hold u and v: no perspective
};

/// The barycentric coordinates of a triangle from its corners as rounded to the screen:
///     b = ((x - xA) (yC - yA) - (y - yA) (xC - xA)) / area,    c = ((y - yA) (xB - xA) - (x - xA) (yB - yA)) / area,
/// linear in x and y; each quantity is A's + b (B's - A's) + c (C's - A's). So at a pixel centre inside, it lies
/// between its values at the corners, however thin or steep the triangle is. In a triangle thinner than 1/16 pixel it
/// changes along the longest side only. `spans` are the triangle's pixels, at least one; with a single one, quantities
/// have their value at it and no steps. False for a triangle without area or seen from its back.
bool make_barycentric(const std::array<const ScreenPlace*, 3>& corners, std::span<const Span> spans,
                      Barycentric& weights);

/// 1/z over the screen.
LinearQuantity<InverseZ> inverse_z_over(const Barycentric& weights);

/// All gradients, from the values of the triangle's corners; `inverse_z` is from inverse_z_over().
MeshGradients make_mesh_gradients(const Barycentric& weights, const std::array<const CornerValues*, 3>& values,
                                  const LinearQuantity<InverseZ>& inverse_z, const GradientChoice& choice);

}  // namespace oblong

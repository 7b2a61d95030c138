#pragma once

#include <cstdint>

#include "engine/fixed/fixed.h"
#include "engine/math/basis.h"
#include "engine/view/gradients.h"
#include "engine/view/projection.h"

namespace oblong {

/// 1 / multiplier: 2.62.
using InverseMultiplier = Fixed<std::int64_t, 62>;

/// A length in the world at depth 1, units: 32.32.
using WidthAtOne = Fixed<std::int64_t, 32>;

/// Reciprocals of the multipliers, computed once a frame, and the optical centre in half pixels.
struct InverseProjection {
    InverseMultiplier inverse_x, inverse_y;
    std::int32_t centre_x_1 = 0, centre_y_1 = 0;
    /// The least width of a pixel on any surface, divided by its depth. On a surface at right angles to the ray, a
    /// pixel at angle a from straight ahead is cos^2 a / multiplier of its distance wide, which is depth / cos a: cos a
    /// / multiplier of its depth; a is greatest in a corner. A sheared view is a part of a larger one whose middle is
    /// straight ahead.
    WidthAtOne least_pixel_width;
};

/// Requires is_drawable(). The shear is the distance of straight ahead from the middle of the screen, across and down,
/// in units at depth 1.
InverseProjection make_inverse_projection(const Projection& projection, Unit shear_x = {}, Unit shear_y = {});

/// The texture mapping of a plane relative to the eye, in world axes.
struct TextureAxes {
    Vec3<TexelAxis> s, t;
    Texel eye_u, eye_v;  ///< texture coordinates of the eye, relative to the surface
    int mip = 0;
};

/// 1/z of a plane over the screen.
struct PlaneInverseZ : LinearQuantity<InverseZ> {
    InverseZ ahead{};  ///< at the optical centre
};

/// 1/z of a plane, from the plane and not from vertices, so that all faces on it get the same bits (hard case E11).
/// With p = z (X, Y, 1) on the plane, N the normal in viewspace and D > 0 the eye's distance in front of it, 1/z = -N .
/// (X, Y, 1) / D (Abrash, Black Book, ch. 66). `rays` are the view's: p = z (X right + Y up + forward).
PlaneInverseZ make_inverse_z(const Vec3<Unit>& normal, PlaneDistance eye_distance, const Basis& rays,
                             const InverseProjection& projection);

/// The screen gradients of a plane with known 1/z: u/z = S . (X, Y, 1) + eye_u / z.
TextureGradients make_texture_gradients(const TextureAxes& axes, const PlaneInverseZ& inverse_z, const Basis& rays,
                                        const InverseProjection& projection);

/// The same for a parallel view, where 1/z is 1 / `depth` everywhere. With F along the rays, P = (X, Y, 0) on the
/// screen's plane through the eye and D the eye's distance in front of the plane, the ray meets it after t = -(N . P
/// depth + D) / N . F, so that u = S . P depth + eye_u + (S . F) t: linear, without a division.
TextureGradients make_parallel_gradients(const TextureAxes& axes, const Vec3<Unit>& normal, PlaneDistance eye_distance,
                                         InverseZ inverse_z, const Basis& rays, const InverseProjection& projection);

}  // namespace oblong

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/math/vec.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/raster/scan.h"
#include "engine/view/gradients.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"

namespace oblong {

/// How the pixels of a triangle are found. All find exactly the same ones: those whose centre is inside, on a left edge
/// (not horizontal, with the triangle on its right; there may be two) or on a top edge (horizontal, above the rest).
enum class TriangleMethod : std::uint8_t {
    FlatParts,     ///< split at the middle corner's height into a part with a flat bottom and a part with a flat top
    EdgeWalking,   ///< the engine's scan_convex(): each edge fills the columns of its side
    EdgeFunctions  ///< every pixel of the bounding box is tested against each edge (Pineda)
};
inline constexpr int kTriangleMethodCount = 3;
const char* name_of(TriangleMethod method);

using ScreenTriangle = std::array<ScreenVertex, 3>;

/// Finds the pixels of triangles in a part of the screen. Threads that draw one picture each have a scanner for a band
/// of rows; the pixels do not depend on the number of bands.
class TriangleScanner {
  public:
    TriangleScanner(TriangleMethod method, const ScreenRectangle& part,
                    EdgeRowKernel kernel = best_kernels().inside_edges);

    /// Appends the triangle's pixels, a span a row from top to bottom. Corners may run either way; a triangle without
    /// area has no pixels. Coordinates beyond kLargestScreen are clamped.
    void scan(const ScreenTriangle& triangle, std::vector<Span>& spans);

  private:
    TriangleMethod method_;
    ScreenRectangle part_;
    EdgeRowKernel kernel_;
    ScanlineExtents rows_;
};

/// Barycentric coordinates of a place in a triangle A, B, C: the place is (a A + b B + c C) / whole. Each weight is
/// twice the signed area of the triangle of the place and the side opposite the corner; it is below 0 beyond that side,
/// and above the whole beyond the corner. The whole is above 0 if the corners run clockwise, and 0 without area.
/// Coordinates beyond kLargestScreen are clamped.
struct BarycentricWeights {
    ScreenArea a, b, c, whole;
};
BarycentricWeights barycentric_weights(const ScreenTriangle& triangle, ScreenVertex place);

/// A quantity that is linear on the screen: a colour or a light; for textures u/z and 1/z, never u itself.
using CornerQuantity = Fixed<std::int64_t, 32>;

/// The quantity with these values at the corners; each step is rounded to nearest. 0 everywhere for a triangle without
/// area.
LinearQuantity<CornerQuantity> quantity_over(const ScreenTriangle& triangle,
                                             const std::array<CornerQuantity, 3>& at_corners);

/// A corner of a triangle in viewspace, and the texel that it shows.
struct TexturedCorner {
    Vec3<Fixed<std::int32_t, 14>> position;  ///< within 2^15 units of the eye along each axis
    Texel u, v;                              ///< from 0 to 65,536
};

/// The screen gradients of 1/z, u/z and v/z of a triangle. At the centre of `anchor` they are within half a step of
/// their formats, and each column or row away from it adds half a step, so spans anchored in their middle are accurate
/// in any mode. None for a triangle seen edge-on.
///
/// With corners A, B, C, N = A x B + B x C + C x A and D = A . (B x C), the point seen along P = (X, Y, 1) has
///     1/z = N . P / D,    u/z = (uA (B x C) + uB (C x A) + uC (A x B)) . P / D.
/// Determinants are exact; the rest has 62 significant bits.
std::optional<TextureGradients> make_triangle_gradients(const std::array<TexturedCorner, 3>& corners,
                                                        const Projection& projection, PixelPosition anchor);

}  // namespace oblong

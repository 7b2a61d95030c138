#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/raster/kernels/edge_functions.h"
#include "engine/raster/scan.h"
#include "engine/view/gradients.h"
#include "engine/view/screen.h"

namespace oblong {

/// How the pixels of a triangle are found. All cover exactly the same ones: those whose centre is inside, on a left
/// edge (not horizontal, the triangle on its right: there may be two) or on a top edge (horizontal, above the rest).
enum class TriangleMethod : std::uint8_t {
    FlatParts,     ///< cut at the middle corner's height into one with a flat bottom and one with a flat top
    EdgeWalking,   ///< the engine's scan_convex(): each edge fills the columns of its side
    EdgeFunctions  ///< every pixel of the bounding box asks on which side of each edge it lies (Pineda)
};
inline constexpr int kTriangleMethodCount = 3;
const char* name_of(TriangleMethod method);

using ScreenTriangle = std::array<ScreenVertex, 3>;

/// Finds the pixels of triangles in a part of the screen. Threads that draw one picture have a scanner each, for bands
/// of rows that do not overlap: the pixels are the same, whatever their number.
class TriangleScanner {
  public:
    TriangleScanner(TriangleMethod method, const ScreenRectangle& part, EdgeRowKernel kernel = inside_edges_sse2);

    /// Appends the triangle's pixels, a span a row from top to bottom. Its corners may run either way round; one
    /// without area covers nothing. Coordinates beyond kLargestScreen are clamped.
    void scan(const ScreenTriangle& triangle, std::vector<Span>& spans);

  private:
    void append_rows(std::vector<Span>& spans) const;

    TriangleMethod method_;
    ScreenRectangle part_;
    EdgeRowKernel kernel_;
    ScanlineExtents rows_;
};

/// Barycentric coordinates of a place in a triangle A, B, C: it is (a A + b B + c C) / whole. They are twice the signed
/// areas of the triangles that the place makes with the side opposite each corner; one is below 0 beyond its side, and
/// above the whole beyond its corner. The whole is above 0 if the corners run clockwise, and 0 without area.
/// Coordinates beyond kLargestScreen are clamped.
struct BarycentricWeights {
    ScreenArea a, b, c, whole;
};
BarycentricWeights barycentric_weights(const ScreenTriangle& triangle, ScreenVertex place);

/// A quantity that is linear on the screen: its share of a colour, a light; of a texture u/z and 1/z, never u itself.
using CornerQuantity = Fixed<std::int64_t, 32>;

/// The quantity that has these values at the corners, by their weights; each step is the nearest. 0 everywhere for a
/// triangle without area.
LinearQuantity<CornerQuantity> quantity_over(const ScreenTriangle& triangle,
                                             const std::array<CornerQuantity, 3>& at_corners);

}  // namespace oblong

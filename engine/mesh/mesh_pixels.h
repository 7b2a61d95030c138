#pragma once

#include <cstdint>

#include "engine/mesh/mesh_gradients.h"
#include "engine/raster/depth.h"
#include "engine/raster/scan.h"
#include "engine/surface/colormap.h"

namespace oblong {

/// How a triangle's pixels are coloured.
struct MeshPaint {
    const Skin& skin;  ///< width * height texels, at least one
    const Colormap& colormap;
    const MeshLight& light;
    Shading shading = Shading::Gouraud;
    bool is_affine = false;                     ///< the gradients are affine
    Vec3<Unit> halfway;                         ///< for Shading::Phong: of the directional light
    const HighlightTable* highlight = nullptr;  ///< for Shading::Phong
    const std::uint8_t* colours = nullptr;      ///< maps the lit colours to 256 others, for fog; or null
};

/// The part of a picture that a mesh may write, with its depth.
struct MeshTarget {
    DepthBuffer& depth;
    Framebuffer out;
    ScreenRectangle part;  ///< where `depth` is valid
};

/// Appends scanned rows, clipped to `part`.
void append_spans(const ScanlineExtents& rows, const ScreenRectangle& part, std::vector<Span>& spans);

/// The spans of a triangle within `part`, equal to those of scan_convex(). None if it is seen from its back.
void find_triangle_spans(const std::array<ScreenVertex, 3>& corners, const ScreenRectangle& part, ScanlineExtents& rows,
                         std::vector<Span>& spans);

/// Whether something is nearer at every pixel of the spans. 1/z counts from the first pixel of `weights`.
bool is_covered(std::span<const Span> spans, const Barycentric& weights, const LinearQuantity<InverseZ>& inverse_z,
                DepthBuffer& depth);

/// Draws the pixels of a triangle's spans where nothing is nearer, and sets their depth. Returns how many were drawn.
std::int64_t draw_mesh_spans(std::span<const Span> spans, const MeshGradients& gradients, const MeshPaint& paint,
                             const MeshTarget& target);

}  // namespace oblong

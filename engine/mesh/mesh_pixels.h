#pragma once

#include <cstdint>

#include "engine/mesh/mesh_gradients.h"
#include "engine/raster/depth.h"
#include "engine/raster/scan.h"
#include "engine/surface/colormap.h"

namespace oblong {

/// What the pixels of a triangle are made of.
struct MeshPaint {
    const Skin& skin;  ///< with width * height texels, at least one
    const Colormap& colormap;
    const MeshLight& light;
    Shading shading = Shading::Gouraud;
    bool is_affine = false;                     ///< the gradients are
    Vec3<Unit> halfway;                         ///< of Shading::Phong, to the directional light
    const HighlightTable* highlight = nullptr;  ///< of Shading::Phong
    const std::uint8_t* after = nullptr;        ///< 256 colours for the lit ones, for fog; null: they stay
};

/// The pixels of a picture that a mesh may write, with their depth.
struct MeshTarget {
    DepthBuffer& depth;
    Framebuffer out;
    ScreenRectangle part;  ///< depth is wanted in all of it
};

/// Appends what of scanned rows lies within a part of the screen.
void append_spans(const ScanlineExtents& rows, const ScreenRectangle& part, std::vector<Span>& spans);

/// The spans of the pixels within a part of the screen that a triangle covers, as scan_convex() finds them. None if it
/// is seen from its back.
void find_triangle_spans(const std::array<ScreenVertex, 3>& corners, const ScreenRectangle& part, ScanlineExtents& rows,
                         std::vector<Span>& spans);

/// Whether something is nearer at each of those pixels.
bool is_covered(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z, DepthBuffer& depth);

/// Draws those pixels of spans of a triangle at which nothing is nearer, and sets their depth. Returns how many.
std::int64_t draw_mesh_spans(std::span<const Span> spans, const MeshGradients& gradients, const MeshPaint& paint,
                             const MeshTarget& target);

}  // namespace oblong

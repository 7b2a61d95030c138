#pragma once

#include "engine/frame/claims.h"
#include "engine/frame/texture_spans.h"
#include "engine/geometry/texture_gradients.h"
#include "engine/raster/kernels/effect_kernels.h"
#include "engine/scene/face_surface.h"

namespace oblong {

/// How surfaces are drawn: plain texels, or with what these members say (EffectTexels).
struct SurfaceDrawing {
    bool is_plain = true;
    TexelTraits traits;
    const ColourRow* colours = nullptr;
    const BlendTable* blend = nullptr;
};

/// A face's surface of one mip level, and the kernel that draws it if that is not the surface's own (TexturedFace).
struct PreparedSurface {
    FaceSurface surface;
    EffectKernel effect_kernel = nullptr;
    EffectTexels texels;
};

/// Draws spans of a face with a surface. Changes nothing but the pixels, the scratch and the counts of `drawing`.
void draw_prepared(const ClaimedFace& claimed, const PreparedSurface& prepared, std::span<const Span> spans,
                   const FrameContext& frame, const FrameWorkspace& work, const SpanDrawing& drawing);

/// Draws spans of a face with its surface: texture, light, mip levels.
void draw_surface(const ClaimedFace& claimed, std::span<const Span> spans, const SurfaceDrawing& drawing,
                  const FrameContext& frame, FrameWorkspace& work);

/// Draws all spans of the faces of a list so.
void draw_surfaces(FaceList list, const SurfaceDrawing& drawing, const FrameContext& frame, FrameWorkspace& work);

/// The gradients of 1/z, u/z and v/z of a face with this surface, in as many bits as the settings keep.
TextureGradients gradients_of(const VisibleFace& visible, const FaceSurface& surface, const FrameContext& frame,
                              const FrameWorkspace& work);

}  // namespace oblong

#pragma once

#include "engine/frame/claims.h"
#include "engine/frame/texture_spans.h"
#include "engine/raster/kernels/effect_kernels.h"
#include "engine/scene/face_surface.h"
#include "engine/view/texture_gradients.h"

namespace oblong {

/// How surfaces are drawn: plain texels, or with what these members say (EffectTexels).
struct SurfaceDrawing {
    bool is_plain = true;
    TexelTraits traits;
    const ColourRow* colours = nullptr;
    const BlendTable* blend = nullptr;
};

/// Draws spans of a face with a surface that it has got. Changes nothing but the pixels, the scratch and the counts of
/// `drawing`: several may do it at once.
void draw_with_surface(const ClaimedFace& claimed, const FaceSurface& surface, const SurfaceEffect& effect,
                       std::span<const Span> spans, const FrameContext& frame, const FrameWorkspace& work,
                       const SpanDrawing& drawing);

/// Draws spans of a face with its surface: texture, light, mip levels. Where threads share in the frame
/// (SharedDrawing), they are handed over.
void draw_surface(const ClaimedFace& claimed, std::span<const Span> spans, const SurfaceDrawing& drawing,
                  const FrameContext& frame, FrameWorkspace& work);

/// Draws all spans of the faces of a list so.
void draw_surfaces(FaceList list, const SurfaceDrawing& drawing, const FrameContext& frame, FrameWorkspace& work);
/// Hands over those faces of a list that were not, as the list grows.
void share_surfaces(FaceList list, const SurfaceDrawing& drawing, const FrameContext& frame, FrameWorkspace& work);

/// The gradients of 1/z, u/z and v/z of a face with this surface, in as many bits as the settings keep.
TextureGradients gradients_of(const VisibleFace& visible, const FaceSurface& surface, const FrameContext& frame,
                              const FrameWorkspace& work);

}  // namespace oblong

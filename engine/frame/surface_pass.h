#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/frame/claims.h"
#include "engine/frame/observers.h"
#include "engine/frame/span_texturing.h"
#include "engine/raster/kernels/effect_kernels.h"
#include "engine/raster/texture_blocks.h"
#include "engine/scene/face_surface.h"
#include "engine/view/screen.h"
#include "engine/view/texture_gradients.h"

namespace oblong {

struct FrameContext;
struct ViewScratch;

/// How a pass draws surfaces: plain texels, or with effects (EffectTexels).
struct SurfaceOptions {
    bool is_plain = true;     ///< ignores all members below except `is_observed`
    bool is_observed = true;  ///< counted and recorded, if the frame is
    TexelTraits traits;
    const ColourRow* colours = nullptr;
    const BlendTable* blend = nullptr;
};

/// An effect kernel used instead of the surface's kernel, and its arguments. Empty: plain texels.
struct SurfaceEffect {
    EffectKernel kernel = nullptr;
    EffectTexels texels;
    bool warps_alone = false;  ///< no other effect
};

/// A face at one mip level, and how its spans are cut into blocks.
struct TexturedFace {
    VisibleFace face;
    FaceSurface surface;
    SurfaceEffect effect;
    BlockCutting cutting;           ///< gradients are rounded to the dials' bits
    TexelDensity texels_per_pixel;  ///< a lower bound at its nearest pixel, of mip level 0
};

/// Sets all of `face.cutting` from its gradients, for these spans of the face.
void set_cutting(TexturedFace& face, std::span<const Span> spans, const SpanTexturing& texturing);

/// The least width in texels of mip level 0 of a pixel at depth z (PreparedFace::least_density,
/// InverseProjection::least_pixel_width).
inline TexelDensity texels_across(View z, TexelDensity least_density, WidthAtOne least_pixel_width) {
    return product<TexelDensity>(product<WidthAtOne>(z, least_pixel_width, Rounding::Floor), least_density,
                                 Rounding::Floor);
}

/// How and where spans are drawn.
struct SpanTarget {
    const SpanTexturing& texturing;
    Framebuffer out;
    SpanScratch& scratch;
    FrameObservers observers = {};
};

/// Draws all or some of the spans for which face.cutting was set: as blocks, or with a division at each pixel if the
/// dials say so or bounded blocks would be too short. Changes only pixels, scratch and observers, so threads may
/// call it concurrently.
void draw_textured(const TexturedFace& face, std::span<const Span> spans, const SpanTarget& target);

/// Draws spans of a face: chooses the mip level, gets the surface, makes gradients, and draws (draw_textured) or hands
/// over to other threads (SharedDrawing).
void draw_surface(const VisibleFace& claimed, std::span<const Span> spans, const SurfaceOptions& options,
                  const FrameContext& frame, ViewScratch& scratch);
/// The same for all spans of these faces.
void draw_surfaces(std::span<const VisibleFace> faces, const SurfaceOptions& options, const FrameContext& frame,
                   ViewScratch& scratch);

/// Draws the walls claimed since the last call. With several threads it is also called while faces claim (claim_faces).
void draw_walls(const FrameContext& frame, ViewScratch& scratch);

/// 1/z of a face that owns pixels, rounded to the dials' bits.
LinearQuantity<InverseZ> inverse_z_of(const VisibleFace& face, const FrameContext& frame);

}  // namespace oblong

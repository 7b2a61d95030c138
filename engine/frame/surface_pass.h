#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/frame/claims.h"
#include "engine/frame/observers.h"
#include "engine/raster/kernels/effect_kernels.h"
#include "engine/raster/texture_blocks.h"
#include "engine/scene/face_surface.h"
#include "engine/view/screen.h"
#include "engine/view/texture_gradients.h"

namespace oblong {

/// How spans are textured, by the accuracy settings; computed once a frame.
struct SpanTexturing {
    Texturing texturing = Texturing::Bounded;
    BlockRule rule;
    BlockCutter cut_blocks = nullptr;
    BlockCutter cut_pixels = nullptr;  ///< blocks of one pixel
    bool divides_exactly = true;       ///< false: by another method, for which there are blocks only
};
SpanTexturing make_span_texturing(const Accuracy& accuracy);

/// How a list of faces is drawn from its surfaces: plain texels, or with what these members say (EffectTexels).
struct SurfaceDrawing {
    bool is_plain = true;
    bool is_noted = true;  ///< counted and recorded, where the frame is
    TexelTraits traits;
    const ColourRow* colours = nullptr;
    const BlendTable* blend = nullptr;
};

/// What draws a surface instead of its own kernel, and what that needs. Empty: plain texels.
struct SurfaceEffect {
    EffectKernel kernel = nullptr;
    EffectTexels texels;
    bool warps_alone = false;  ///< it does nothing else
};

/// Spans of a face with one mip level of its texture, and how they are cut into blocks.
struct TexturedFace {
    VisibleFace face;
    FaceSurface surface;
    SurfaceEffect effect;
    BlockCutting cutting;         ///< its gradients are in as many bits as the settings keep
    TexelDensity nearest_texels;  ///< texels of mip level 0 across the nearest pixel, or fewer
};

/// Sets how these spans of a face are cut, from its gradients on.
void set_cutting(TexturedFace& face, std::span<const Span> spans, const SpanTexturing& texturing);

/// How many texels of mip level 0 a pixel this near is wide at least (PreparedFace::least_density,
/// InverseProjection::least_pixel_width).
inline TexelDensity texels_across(View z, TexelDensity least_density, WidthAtOne least_pixel_width) {
    return product<TexelDensity>(product<WidthAtOne>(z, least_pixel_width, Rounding::Floor), least_density,
                                 Rounding::Floor);
}

/// Scratch of whoever textures spans; two that do so at once have one each.
struct SpanScratch {
    /// For spans of up to `longest_px` pixels.
    explicit SpanScratch(std::int32_t longest_px) : blocks(longest_px) {}

    std::vector<Span> long_blocks, short_blocks;  ///< those that bounded texturing draws as blocks, and pixel by pixel
    BlockList blocks;
};

/// How and where spans are textured.
struct SpanDrawing {
    const SpanTexturing& texturing;
    Framebuffer out;
    SpanScratch& scratch;
    FrameObservers observers = {};
};

/// Draws spans of a face, those that its cutting is for or some of them: as blocks, or with a division at each pixel
/// where the settings ask for that, or where bounded blocks would be so short that it is cheaper. Changes nothing but
/// pixels, the scratch and what observers keep: several may do it at once.
void draw_textured(const TexturedFace& face, std::span<const Span> spans, const SpanDrawing& drawing);

/// Scratch of a view's surfaces.
struct SurfaceScratch {
    explicit SurfaceScratch(std::int32_t longest_px) : spans(longest_px) {}

    std::array<std::vector<Span>, 4> of_mip;  ///< the current face's spans that each mip level draws
    SpanScratch spans;
};

/// Draws spans of a face with its surface: texture, light, mip levels. Where threads share in the frame
/// (SharedDrawing), they are handed over.
void draw_surface(const VisibleFace& claimed, std::span<const Span> spans, const SurfaceDrawing& drawing,
                  const FrameContext& frame, ViewScratch& scratch);
/// Draws all spans of some faces so.
void draw_surfaces(std::span<const VisibleFace> faces, const SurfaceDrawing& drawing, const FrameContext& frame,
                   ViewScratch& scratch);

/// Draws the walls that were not drawn since their list was begun: perhaps while it grows.
void draw_walls(const FrameContext& frame, ViewScratch& scratch);

/// 1/z of a face that owns pixels, in as many bits as the settings keep.
LinearQuantity<InverseZ> inverse_z_of(const VisibleFace& face, const FrameContext& frame);

}  // namespace oblong

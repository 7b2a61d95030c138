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

/// What a pass asks for when it draws faces with their surfaces: plain texels, or effects on them (EffectTexels).
struct SurfaceOptions {
    bool is_plain = true;  ///< what follows but `is_noted` is not looked at
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
    BlockCutting cutting;           ///< its gradients are in as many bits as the settings keep
    TexelDensity texels_per_pixel;  ///< at its nearest pixel, of mip level 0: so many or more
};

/// Sets all of `face.cutting` but the gradients, from which it follows, for these spans of the face.
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

/// What spans are textured by, and into.
struct SpanTarget {
    const SpanTexturing& texturing;
    Framebuffer out;
    SpanScratch& scratch;
    FrameObservers observers = {};
};

/// Draws spans of a face, those that its cutting is for or some of them: as blocks, or with a division at each pixel
/// where the settings ask for that, or where bounded blocks would be so short that it is cheaper. Changes nothing but
/// pixels, the scratch and what observers keep: several may do it at once.
void draw_textured(const TexturedFace& face, std::span<const Span> spans, const SpanTarget& target);

/// Scratch of a view's surfaces.
struct SurfaceScratch {
    explicit SurfaceScratch(std::int32_t longest_px) : spans(longest_px) {}

    std::array<std::vector<Span>, 4> of_mip;  ///< the current face's spans that each mip level draws
    SpanScratch spans;
};

/// Draws spans of a face with its surface: chooses the mip level, gets the lit texture, makes gradients, and draws
/// (draw_textured), or hands all that to other threads (SharedDrawing).
void draw_surface(const VisibleFace& claimed, std::span<const Span> spans, const SurfaceOptions& options,
                  const FrameContext& frame, ViewScratch& scratch);
/// The same of all spans of these faces.
void draw_surfaces(std::span<const VisibleFace> faces, const SurfaceOptions& options, const FrameContext& frame,
                   ViewScratch& scratch);

/// Draws the walls that were claimed since it was called last. With several threads that is while faces still claim
/// (claim_faces); else it is called once, by the walls' pass.
void draw_walls(const FrameContext& frame, ViewScratch& scratch);

/// 1/z of a face that owns pixels, in as many bits as the settings keep.
LinearQuantity<InverseZ> inverse_z_of(const VisibleFace& face, const FrameContext& frame);

}  // namespace oblong

#pragma once

#include <span>
#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/frame/claims.h"
#include "engine/raster/kernels/effect_kernels.h"
#include "engine/raster/texture_blocks.h"
#include "engine/scene/face_surface.h"
#include "engine/view/screen.h"
#include "engine/view/texture_gradients.h"

namespace oblong {

struct FrameCounts;
struct FrameRecord;

/// How spans are textured, by the accuracy settings; computed once a frame.
struct SpanTexturing {
    Texturing texturing = Texturing::Bounded;
    BlockRule rule;
    BlockCutter cut_blocks = nullptr;
    BlockCutter cut_pixels = nullptr;  ///< blocks of one pixel
    bool divides_exactly = true;       ///< false: by another method, for which there are blocks only
};
SpanTexturing make_span_texturing(const Accuracy& accuracy);

/// What draws a surface instead of its own kernel, and what that needs. Empty: plain texels.
struct SurfaceEffect {
    EffectKernel kernel = nullptr;
    EffectTexels texels;
    bool warps_alone = false;  ///< it does nothing else
};

/// A face on the screen with one mip level of its texture.
struct TexturedFace {
    const ClaimedFace& claimed;
    const FaceSurface& surface;
    const SurfaceEffect& effect;
    const TextureGradients& gradients;
    TexelDensity least_density;    ///< PreparedFace::least_density
    WidthAtOne least_pixel_width;  ///< InverseProjection::least_pixel_width
};

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
    FrameCounts* counts = nullptr;  ///< null: nothing is counted
    FrameRecord* record = nullptr;  ///< null: nothing is recorded
};

/// Draws spans of a face: as blocks, or with a division at each pixel where the
/// settings ask for that, or where bounded blocks would be so short that it is cheaper.
void draw_texture_spans(const TexturedFace& face, std::span<const Span> spans, const SpanDrawing& drawing);

}  // namespace oblong

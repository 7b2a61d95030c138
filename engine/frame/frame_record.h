#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/frame/observers.h"
#include "engine/raster/texture_blocks.h"
#include "engine/scene/face_surface.h"
#include "engine/scene/placed_models.h"
#include "engine/view/screen.h"
#include "engine/visibility/front_to_back.h"

namespace oblong {

/// What one pixel of a frame shows.
struct PixelRecord {
    FaceIndex face = FaceIndex::none();       ///< none: no face, or the void
    PlacedIndex model = PlacedIndex::none();  ///< of the scene's models; none: the world
    std::int8_t mip = -1;                     ///< -1: no texels: sky, or one colour
    Texel u, v;  ///< s . p + s_offset, t . p + t_offset that is sampled: texels of mip level 0
};

/// What each pixel of a frame shows, recorded only on request (FrameObservers): for measuring errors.
struct FrameRecord {
    std::vector<PixelRecord> pixels;  ///< one a pixel of the framebuffer, its pitch included
};

/// Counts and records spans of a face that are drawn without a surface, if anyone asks.
void note_spans(const VisibleFace& face, std::span<const Span> spans, Framebuffer out, const FrameObservers& observers);

/// A pixel of a face, without texels.
PixelRecord record_of(const VisibleFace& visible);
/// Records pixels of spans that all show `face`, without texels.
void record_spans(const PixelRecord& face, std::span<const Span> spans, Framebuffer out, FrameRecord& record);
/// Records the texels of blocks of a surface, whose pixels are of `face`.
void record_blocks(PixelRecord face, std::span<const TexelBlock> blocks, const FaceSurface& surface,
                   FrameRecord& record);
/// Records the texels of pixels that raster/exact_spans.h has drawn.
void record_divided_pixels(PixelRecord face, std::span<const Span> spans, const BlockCutting& cutting,
                           const FaceSurface& surface, Framebuffer out, FrameRecord& record);

}  // namespace oblong

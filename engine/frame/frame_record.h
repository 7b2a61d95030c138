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

/// What a pixel of a frame shows.
struct PixelRecord {
    FaceIndex face = FaceIndex::none();       ///< none: no face, or the void
    PlacedIndex model = PlacedIndex::none();  ///< in the scene's models; none: the world
    std::int8_t mip = -1;                     ///< -1: no texels: sky, or one colour
    Texel u, v;                               ///< sampled s . p + s_offset, t . p + t_offset: texels of mip level 0
};

/// What each pixel of a frame shows, recorded on request (FrameObservers) to measure errors.
struct FrameRecord {
    std::vector<PixelRecord> pixels;  ///< one for each pixel of the framebuffer, with its pitch
};

/// Counts and records spans of a face drawn without a surface, if there are observers.
void observe_spans(const VisibleFace& face, std::span<const Span> spans, Framebuffer out,
                   const FrameObservers& observers);

/// A record of a face, without texels.
PixelRecord record_of(const VisibleFace& visible);
/// Records `face` for all pixels of spans.
void record_spans(const PixelRecord& face, std::span<const Span> spans, Framebuffer out, FrameRecord& record);
/// Records `face` and the texels of blocks of its surface.
void record_blocks(PixelRecord face, std::span<const TexelBlock> blocks, const FaceSurface& surface,
                   FrameRecord& record);
/// The same for spans drawn by raster/exact_spans.h.
void record_divided_pixels(PixelRecord face, std::span<const Span> spans, const BlockCutting& cutting,
                           const FaceSurface& surface, Framebuffer out, FrameRecord& record);

}  // namespace oblong

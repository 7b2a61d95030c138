#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/raster/kernels/kernels.h"
#include "engine/scene/effects.h"
#include "engine/screen/screen.h"

namespace oblong {

/// Statistics of a frame, collected only on request (FrameWorkspace::counts).
struct FrameCounts {
    std::int64_t faces_visited = 0, faces_drawn = 0, spans = 0, divisions = 0;
    std::vector<std::uint8_t> writes;         ///< of each pixel, by faces, those of the sky too; at most 255
    std::vector<std::int64_t> effect_pixels;  ///< of each Effect: those of the faces that need it
};

/// Counts of a frame in `out` that has drawn nothing yet.
FrameCounts make_frame_counts(const Framebuffer& out);

/// Adds a face that owns `spans`, and their pixels to the effects that it needs.
void count_face(EffectSet effects, std::span<const Span> spans, FrameCounts& counts);
/// Adds a write to each pixel of spans or blocks. `pitch` is the framebuffer's.
void count_writes(std::span<const Span> spans, std::int32_t pitch, FrameCounts& counts);
void count_writes(std::span<const TexelBlock> blocks, FrameCounts& counts);

}  // namespace oblong

#pragma once

#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/raster/texture_blocks.h"
#include "engine/view/screen.h"

namespace oblong {

/// The dials for texturing spans, computed once a frame.
struct SpanTexturing {
    Texturing texturing = Texturing::Bounded;
    BlockRule rule;
    BlockCutter cut_blocks = nullptr;
    BlockCutter cut_pixels = nullptr;  ///< blocks of one pixel
    bool divides_exactly = true;       ///< false: by a table method, for which only blocks exist
    const Kernels* kernels = nullptr;
};
SpanTexturing make_span_texturing(const Accuracy& accuracy, const Kernels& kernels = best_kernels());

/// Scratch for texturing spans; one for each thread.
struct SpanScratch {
    /// For spans of up to `longest_px` pixels.
    explicit SpanScratch(std::int32_t longest_px) : blocks(longest_px) {}

    std::vector<Span> block_spans, pixel_spans;  ///< drawn as blocks, and pixel by pixel
    BlockList blocks;
};

}  // namespace oblong

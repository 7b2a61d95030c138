#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "engine/raster/span.h"
#include "engine/screen/framebuffer.h"

namespace oblong {

/// Paints spans in one colour.
inline void fill_spans(std::span<const Span> spans, std::uint8_t colour, Framebuffer out) {
    for (const Span& span : spans) std::fill(out.row(span.y) + span.first, out.row(span.y) + span.end, colour);
}

}  // namespace oblong

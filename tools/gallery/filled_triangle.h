#pragma once

#include <vector>

#include "engine/methods/triangles.h"
#include "tools/gallery/canvas.h"

namespace oblong {

inline ScreenVertex vertex_at(const Vec& at) {
    return {fixed_of<Screen>(at.x), fixed_of<Screen>(at.y)};
}

inline ScreenTriangle triangle_of(const Vec& a, const Vec& b, const Vec& c) {
    return {vertex_at(a), vertex_at(b), vertex_at(c)};
}

/// The spans of a triangle in a canvas, by edge functions.
inline std::vector<Span> spans_in(const ScreenTriangle& triangle, Framebuffer canvas) {
    std::vector<Span> spans;
    TriangleScanner(TriangleMethod::EdgeFunctions, {0, canvas.width_px, 0, canvas.height_px}).scan(triangle, spans);
    return spans;
}

/// Each pixel of a triangle has the colour that colour_at(column, row) gives.
template <class ColourAt>
void fill_triangle(const ScreenTriangle& triangle, Framebuffer canvas, const ColourAt& colour_at) {
    for (const Span& span : spans_in(triangle, canvas))
        for (std::int32_t x = span.first; x < span.end; ++x) canvas.row(span.y)[x] = colour_at(x, span.y);
}

}  // namespace oblong

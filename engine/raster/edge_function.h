#pragma once

#include <algorithm>
#include <array>

#include "engine/raster/scan.h"
#include "engine/view/gradients.h"
#include "engine/view/screen.h"

namespace oblong {

/// The edge function of a clockwise triangle's edge (y down):
///     (to.x - from.x)(y - from.y) - (to.y - from.y)(x - from.x),
/// twice the area of the triangle of edge and place; positive to the right of the edge, which is inside.
inline ScreenArea edge_function(ScreenVertex from, ScreenVertex to, ScreenVertex place) {
    return widening_product(to.x - from.x, place.y - from.y) - widening_product(to.y - from.y, place.x - from.x);
}

/// An edge function at pixel centres, counted from the first one of `box`; floored to 1/256 of a pixel's area. Steps
/// per pixel are whole multiples of that, so the sign is exact. If the edge is neither left nor top, 2^-16 is
/// subtracted, which puts places on the edge outside.
inline LinearQuantity<ScreenWide> edge_over_pixels(ScreenVertex from, ScreenVertex to, const ScreenRectangle& box) {
    const Screen dx = to.x - from.x, dy = to.y - from.y;
    const bool is_left = dy < Screen{}, is_top = dy == Screen{} && dx > Screen{};
    constexpr auto kHalfPixel = Screen::from_raw(128);
    const ScreenVertex centre{Screen::from_int(box.first_column) + kHalfPixel,
                              Screen::from_int(box.first_row) + kHalfPixel};
    const ScreenArea first = edge_function(from, to, centre) - (is_left || is_top ? ScreenArea{} : ScreenArea::ulp());
    return {convert<ScreenWide>(first, Rounding::Floor), -convert<ScreenWide>(dy), convert<ScreenWide>(dx)};
}

/// The pixels of `part` whose centres are in the bounding box of a triangle; may be empty.
inline ScreenRectangle box_around(const std::array<ScreenVertex, 3>& triangle, const ScreenRectangle& part) {
    const auto& [a, b, c] = triangle;
    const auto least = [](Screen x, Screen y, Screen z) { return std::min(std::min(x, y), z); };
    const auto greatest = [](Screen x, Screen y, Screen z) { return std::max(std::max(x, y), z); };
    return {std::max(first_centre_from(least(a.x, b.x, c.x)), part.first_column),
            std::min(first_centre_from(greatest(a.x, b.x, c.x)), part.end_column),
            std::max(first_centre_from(least(a.y, b.y, c.y)), part.first_row),
            std::min(first_centre_from(greatest(a.y, b.y, c.y)), part.end_row)};
}

}  // namespace oblong

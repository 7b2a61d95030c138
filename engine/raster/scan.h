#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/base/table.h"
#include "engine/view/screen.h"

namespace oblong {

/// For each of the rows [first, end) the columns [left, right) that a polygon covers.
struct ScanlineExtents {
    std::vector<std::int32_t> left, right;  ///< one a row of the screen
    std::int32_t first = 0, end = 0;
    PixelRange columns{0, 0};  ///< from PolygonShape::bounds, hold all spans; may be off the screen

    explicit ScanlineExtents(std::int32_t height_px) : left(as_size(height_px)), right(as_size(height_px)) {}
};

/// The largest magnitude of a screen coordinate in scan_convex(); larger ones are clamped.
inline constexpr Screen kLargestScreen = Screen::from_int(1 << 20);

inline ScreenVertex clamped_vertex(ScreenVertex v) {
    return {std::clamp(v.x, -kLargestScreen, kLargestScreen), std::clamp(v.y, -kLargestScreen, kLargestScreen)};
}

/// The first row or column whose centre is at or after `position`: ceil(position - 1/2). 127 is 1/2 less one step.
constexpr std::int32_t first_centre_from(Screen position) {
    return floor_of(position + Screen::from_raw(127));
}

/// Which walker (edges.h) steps down a polygon's edges.
enum class EdgeWalk : std::uint8_t { OnScreen, Exact, Accumulating };

/// The bounds of a polygon and how to scan it. Of most faces no more is asked: they own no pixel.
struct PolygonShape {
    ScreenRectangle bounds{};  ///< rows are on the screen; columns may be off it
    EdgeWalk walk = EdgeWalk::Exact;
};

/// The bounds hold all pixels of scan_convex(); with EdgeStepping::Accumulated only for polygons on the screen.
PolygonShape shape_of(std::span<const ScreenVertex> vertices, std::int32_t height_px,
                      EdgeStepping stepping = EdgeStepping::Exact);

/// Whether a polygon's outline goes down once and up once, as that of a convex one does.
bool is_monotone(std::span<const ScreenVertex> vertices);

/// Finds the pixels of a convex polygon with clockwise vertices (y down). A pixel is covered if its centre is inside,
/// on a left edge or on a top edge: polygons that share edges share no pixel and leave no gap. Exact edges give the
/// columns of the true edge between the snapped vertices; Accumulated ones drift by up to 2^-17 pixel a row. Columns
/// may be off the screen; rows are on it.
void scan_convex(std::span<const ScreenVertex> vertices, ScanlineExtents& rows,
                 EdgeStepping stepping = EdgeStepping::Exact);

/// The same with a known shape, and only in the rows `within`, a part of the shape's rows.
void scan_convex(std::span<const ScreenVertex> vertices, const PolygonShape& shape, PixelRange within,
                 ScanlineExtents& rows);

/// Square pixels: 48.16.
using ScreenArea = Fixed<std::int64_t, 16>;

/// Twice the signed area; positive if the vertices are clockwise.
ScreenArea doubled_area(std::span<const ScreenVertex> vertices);

}  // namespace oblong

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/base/table.h"
#include "engine/view/screen.h"

namespace oblong {

/// Scanline extents: for each of rows [first, end) the columns [left, right) that a polygon covers.
struct ScanlineExtents {
    std::vector<std::int32_t> left, right;  ///< one a row of the screen
    std::int32_t first = 0, end = 0;
    PixelRange columns{0, 0};  ///< that hold all of the polygon's, by PolygonShape::bounds; some may lie off the screen

    explicit ScanlineExtents(std::int32_t height_px) : left(as_size(height_px)), right(as_size(height_px)) {}
};

/// The largest magnitude of a screen coordinate in scan_convex(); larger ones are clamped.
inline constexpr Screen kLargestScreen = Screen::from_int(1 << 20);

/// The first row or column whose centre lies at or after `position`: ceil(position - 1/2).
constexpr std::int32_t first_centre_from(Screen position) {
    return floor_of(position + Screen::from_raw(127));
}

/// Which walker (edge_walker.h) steps down a polygon's edges.
enum class EdgeWalk : std::uint8_t { OnScreen, Exact, Accumulating };

/// Where a polygon may cover pixels, and what its scan has to know of it, by one look at its corners.
struct PolygonShape {
    ScreenRectangle bounds{};  ///< rows of the screen; columns may lie off it
    bool is_monotone = true;   ///< goes down once and up once, as convex polygons do
    EdgeWalk walk = EdgeWalk::Exact;
};

/// Bounds hold what scan_convex() finds; where edges accumulate, of polygons on the screen only.
PolygonShape shape_of(std::span<const ScreenVertex> vertices, std::int32_t height_px,
                      EdgeStepping stepping = EdgeStepping::Exact);

/// Finds the pixels of a convex polygon whose vertices run clockwise as seen (y down). A pixel is covered when its
/// centre is inside, on a left edge or on a top edge; polygons that share edges share no pixel and leave no gap. Exact
/// edges have the columns of the true edge between the snapped vertices, whatever its slope; Accumulated ones are up to
/// 2^-17 pixel a row beside it. Columns may lie off the screen; rows do not.
void scan_convex(std::span<const ScreenVertex> vertices, ScanlineExtents& rows,
                 EdgeStepping stepping = EdgeStepping::Exact);

/// The same of a polygon's shape, in no rows but `within`, which are some of its own.
void scan_convex(std::span<const ScreenVertex> vertices, const PolygonShape& shape, PixelRange within,
                 ScanlineExtents& rows);

/// Square pixels: 48.16.
using ScreenArea = Fixed<std::int64_t, 16>;

/// Twice the signed area: above 0 if the vertices run clockwise as seen.
ScreenArea doubled_area(std::span<const ScreenVertex> vertices);

}  // namespace oblong

#include "engine/raster/scan.h"

#include <algorithm>
#include <limits>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/raster/edge_walker.h"

namespace oblong {

namespace {

/// Steps down an edge by a slope of 16.16, rounded to the nearest and added up row by row, as games of the time did:
/// the error grows with the edge.
class AccumulatingWalker {
  public:
    AccumulatingWalker(ScreenVertex top, ScreenVertex bottom, std::int32_t row) {
        const ScreenWide dx = widening_difference(bottom.x, top.x), dy = widening_difference(bottom.y, top.y);
        const ScreenWide down = widening_difference(Screen::from_int(row) + Screen::from_raw(128), top.y);
        slope_ = bounded_quotient<Column>(convert<Fixed<std::int64_t, 25>>(dx), dy);
        column_ = Column::from_raw(std::int64_t{top.x.raw} * 256) +
                  convert<Column>(bounded_product(slope_, down), Rounding::Floor);
    }

    std::int32_t column() const {
        constexpr auto kHalf = Column::from_raw(1 << 15);
        return static_cast<std::int32_t>(floor_of(column_ + kHalf - Column::ulp()));
    }
    void next_row() { column_ += slope_; }

  private:
    using Column = Fixed<std::int64_t, 16>;
    Column slope_, column_;
};

struct RowRange {
    std::int32_t first, end;
};

RowRange rows_between(Screen top, Screen bottom, std::int32_t height) {
    return {std::max(first_centre_from(top), 0), std::min(first_centre_from(bottom), height)};
}

template <class Walker>
void walk_edge(ScreenVertex top, ScreenVertex bottom, std::vector<std::int32_t>& columns) {
    const RowRange range = rows_between(top.y, bottom.y, static_cast<std::int32_t>(columns.size()));
    if (range.first >= range.end) return;
    Walker walker(top, bottom, range.first);
    std::int32_t* out = columns.data();
    for (std::int32_t row = range.first; row < range.end; ++row, walker.next_row()) out[row] = walker.column();
}

/// Like walk_edge, but several edges of one side may cross a row: the outermost counts.
template <class Walker>
void widen_by_edge(ScreenVertex top, ScreenVertex bottom, std::vector<std::int32_t>& columns, bool is_left) {
    const RowRange range = rows_between(top.y, bottom.y, static_cast<std::int32_t>(columns.size()));
    if (range.first >= range.end) return;
    Walker walker(top, bottom, range.first);
    for (std::int32_t row = range.first; row < range.end; ++row, walker.next_row()) {
        std::int32_t& column = at(columns, row);
        column = is_left ? std::min(column, walker.column()) : std::max(column, walker.column());
    }
}

ScreenVertex within_limits(ScreenVertex v) {
    return {std::clamp(v.x, -kLargestScreen, kLargestScreen), std::clamp(v.y, -kLargestScreen, kLargestScreen)};
}

/// A polygon's bounds and shape, found before it is scanned.
struct Profile {
    std::int32_t first_row, end_row;
    bool is_monotone;  ///< goes down once and up once, as convex polygons do
};

Profile survey(std::span<const ScreenVertex> vertices, std::int32_t height) {
    Screen top = Screen::highest(), bottom = Screen::lowest();
    int turns = 0, direction = 0, first_direction = 0;
    ScreenVertex from = vertices.back();
    for (const ScreenVertex& to : vertices) {
        top = std::min(top, to.y);
        bottom = std::max(bottom, to.y);
        const int now = (to.y > from.y) - (to.y < from.y);
        from = to;
        if (now == 0) continue;
        if (first_direction == 0) first_direction = now;
        turns += direction != 0 && now != direction;
        direction = now;
    }
    turns += direction != first_direction;
    top = std::min(top, kLargestScreen);
    bottom = std::min(bottom, kLargestScreen);
    return {std::max(first_centre_from(top), 0), std::min(first_centre_from(bottom), height), turns <= 2};
}

/// Snapping and clipping can bend a chain of nearly collinear vertices back by a step. Such a polygon is widened to its
/// outermost edges: its neighbours, which share them, may be overlapped by a sliver, but no gap can open.
template <class Walker>
void scan_bent(std::span<const ScreenVertex> vertices, ScanlineExtents& rows) {
    for (std::int32_t row = rows.first; row < rows.end; ++row) {
        at(rows.left, row) = std::numeric_limits<std::int32_t>::max();
        at(rows.right, row) = std::numeric_limits<std::int32_t>::min();
    }
    ScreenVertex from = within_limits(vertices.back());
    for (const ScreenVertex& vertex : vertices) {
        const ScreenVertex to = within_limits(vertex);
        if (from.y < to.y) widen_by_edge<Walker>(from, to, rows.right, false);
        if (to.y < from.y) widen_by_edge<Walker>(to, from, rows.left, true);
        from = to;
    }
}

template <class Walker>
void scan_edges(std::span<const ScreenVertex> vertices, ScanlineExtents& rows) {
    ScreenVertex from = within_limits(vertices.back());
    for (const ScreenVertex& vertex : vertices) {
        const ScreenVertex to = within_limits(vertex);
        if (from.y < to.y) walk_edge<Walker>(from, to, rows.right);
        if (to.y < from.y) walk_edge<Walker>(to, from, rows.left);
        from = to;
    }
}

}  // namespace

void scan_convex(std::span<const ScreenVertex> vertices, ScanlineExtents& rows, EdgeStepping stepping) {
    rows.first = rows.end = 0;
    if (vertices.size() < 3) return;
    const Profile profile = survey(vertices, static_cast<std::int32_t>(rows.left.size()));
    rows.first = profile.first_row;
    rows.end = profile.end_row;
    if (rows.first >= rows.end) return;
    const bool is_exact = stepping == EdgeStepping::Exact;
    if (!profile.is_monotone)
        is_exact ? scan_bent<ExactWalker>(vertices, rows) : scan_bent<AccumulatingWalker>(vertices, rows);
    else
        is_exact ? scan_edges<ExactWalker>(vertices, rows) : scan_edges<AccumulatingWalker>(vertices, rows);
}

ScreenArea doubled_area(std::span<const ScreenVertex> vertices) {
    ScreenArea sum;
    ScreenVertex from = vertices.back();
    for (const ScreenVertex& to : vertices) {
        sum += widening_product(from.x, to.y) - widening_product(to.x, from.y);
        from = to;
    }
    return sum;
}

}  // namespace oblong

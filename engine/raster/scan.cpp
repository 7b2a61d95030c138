#include "engine/raster/scan.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/raster/edges.h"

namespace oblong {

namespace {

/// Steps down an edge by a rounded slope of 16.16, as games of the time did: the error grows with the edge.
class AccumulatingWalker {
  public:
    AccumulatingWalker(ScreenVertex top, ScreenVertex bottom, std::int32_t row) {
        const ScreenWide dx = widening_difference(bottom.x, top.x), dy = widening_difference(bottom.y, top.y);
        const ScreenWide down = widening_difference(Screen::from_int(row) + kHalfPixel, top.y);
        slope_ = bounded_quotient<Column>(convert<Fixed<std::int64_t, 25>>(dx), dy);
        column_ = convert<Column>(top.x) + convert<Column>(bounded_product(slope_, down), Rounding::Floor);
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

/// Whether ScreenWalker is exact between these: on the screen of the largest mode.
bool are_on_screen(ScreenVertex least, ScreenVertex greatest) {
    constexpr auto kLargest = Screen::from_int(kLargestMode_px);
    return least.x >= Screen{} && least.y >= Screen{} && greatest.x <= kLargest && greatest.y <= kLargest;
}

/// Calls `use(walker, edge, rows of the edge, columns of its side)` for each edge.
template <class Walker, class UseEdge>
void walk_edges(std::span<const ScreenVertex> vertices, ScanlineExtents& rows, const UseEdge& use) {
    const auto usable = [](ScreenVertex v) { return std::is_same_v<Walker, ScreenWalker> ? v : clamped_vertex(v); };
    std::int32_t* const left = rows.left.data();
    std::int32_t* const right = rows.right.data();
    const PixelRange all{rows.first, rows.end};
    ScreenVertex from = usable(vertices.back());
    for (const ScreenVertex& vertex : vertices) {
        const SideEdge edge(from, usable(vertex));
        from = usable(vertex);
        const PixelRange range = edge.rows(all);
        if (range.first >= range.end) continue;
        use(Walker(edge.top, edge.bottom, range.first), edge, range, edge.is_right ? right : left);
    }
}

/// Snapping and clipping can make a chain of nearly collinear vertices turn back by a step. Such a polygon is widened
/// to its outermost edges: it may overlap its neighbours by a sliver, but leaves no gap.
template <class Walker>
void scan_bent(std::span<const ScreenVertex> vertices, ScanlineExtents& rows) {
    std::fill(rows.left.begin() + rows.first, rows.left.begin() + rows.end, std::numeric_limits<std::int32_t>::max());
    std::fill(rows.right.begin() + rows.first, rows.right.begin() + rows.end, std::numeric_limits<std::int32_t>::min());
    walk_edges<Walker>(vertices, rows,
                       [](Walker walker, const SideEdge& edge, PixelRange range, std::int32_t* columns) {
                           for (std::int32_t row = range.first; row < range.end; ++row, walker.next_row()) {
                               const std::int32_t column = walker.column(), so_far = columns[row];
                               columns[row] = edge.is_right ? std::max(so_far, column) : std::min(so_far, column);
                           }
                       });
}

template <class Walker>
void write_columns(Walker walker, std::int32_t count, std::int32_t* columns) {
    for (std::int32_t i = 0; i < count; ++i, walker.next_row()) columns[i] = walker.column();
}

std::int32_t next_column(ScreenWalker& walker) {
    const std::int32_t column = walker.column();
    walker.next_row();
    return column;
}

/// Four at a time. The last may overlap those before: a loop over the remainder would often be mispredicted, which
/// takes longer.
template <>
void write_columns(ScreenWalker walker, std::int32_t count, std::int32_t* columns) {
    if (count < 4) {
        columns[0] = walker.column();
        columns[count / 2] = walker.after(count / 2).column();
        columns[count - 1] = walker.after(count - 1).column();
        return;
    }
    const auto write_four = [](ScreenWalker& from, std::int32_t* to) {
        to[0] = next_column(from);
        to[1] = next_column(from);
        to[2] = next_column(from);
        to[3] = next_column(from);
    };
    ScreenWalker last_four = walker.after(count - 4);
    for (std::int32_t i = 0; i < count - 4; i += 4) write_four(walker, columns + i);
    write_four(last_four, columns + count - 4);
}

template <class Walker>
void scan_edges(std::span<const ScreenVertex> vertices, ScanlineExtents& rows) {
    if (!is_monotone(vertices)) return scan_bent<Walker>(vertices, rows);
    walk_edges<Walker>(vertices, rows,
                       [](const Walker& walker, const SideEdge&, PixelRange range, std::int32_t* columns) {
                           write_columns(walker, range.end - range.first, columns + range.first);
                       });
}

}  // namespace

PolygonShape shape_of(std::span<const ScreenVertex> vertices, std::int32_t height_px, EdgeStepping stepping) {
    if (vertices.size() < 3) return {};
    ScreenVertex least = vertices.back(), greatest = least;
    for (const ScreenVertex& at : vertices) {
        least = {std::min(least.x, at.x), std::min(least.y, at.y)};
        greatest = {std::max(greatest.x, at.x), std::max(greatest.y, at.y)};
    }
    EdgeWalk walk = EdgeWalk::OnScreen;
    if (!are_on_screen(least, greatest)) {
        least = clamped_vertex(least);
        greatest = clamped_vertex(greatest);
        walk = EdgeWalk::Exact;
    }
    ScreenRectangle bounds{first_centre_from(least.x), first_centre_from(greatest.x),
                           std::max(first_centre_from(least.y), 0), std::min(first_centre_from(greatest.y), height_px)};
    if (stepping == EdgeStepping::Accumulated) {
        walk = EdgeWalk::Accumulating;
        --bounds.first_column;
        ++bounds.end_column;
    }
    return {bounds, walk};
}

bool is_monotone(std::span<const ScreenVertex> vertices) {
    Screen least = vertices.back().y, greatest = least, from = least;
    ScreenWide way_down;  // sum of all downward edges
    for (const ScreenVertex& vertex : vertices) {
        const Screen to = vertex.y;
        least = std::min(least, to);
        greatest = std::max(greatest, to);
        const Screen lower = std::max(to, from);  // by a maximum: a branch is mispredicted at every third corner
        way_down += ScreenWide::from_raw(lower.bits() - from.bits());  // in 32 bits, unsigned
        from = to;
    }
    return way_down == widening_difference(greatest, least);
}

void scan_convex(std::span<const ScreenVertex> vertices, const PolygonShape& shape, PixelRange within,
                 ScanlineExtents& rows) {
    rows.first = within.first;
    rows.end = within.end;
    rows.columns = {shape.bounds.first_column, shape.bounds.end_column};
    if (within.first >= within.end) return;
    if (shape.walk == EdgeWalk::OnScreen) return scan_edges<ScreenWalker>(vertices, rows);
    if (shape.walk == EdgeWalk::Exact) return scan_edges<ExactWalker>(vertices, rows);
    scan_edges<AccumulatingWalker>(vertices, rows);
}

void scan_convex(std::span<const ScreenVertex> vertices, ScanlineExtents& rows, EdgeStepping stepping) {
    const PolygonShape shape = shape_of(vertices, static_cast<std::int32_t>(rows.left.size()), stepping);
    scan_convex(vertices, shape, {shape.bounds.first_row, shape.bounds.end_row}, rows);
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

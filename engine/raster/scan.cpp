#include "engine/raster/scan.h"

#include <algorithm>
#include <limits>

#include "engine/base/range_probe.h"

namespace oblong {

namespace {

/// numerator / denominator toward minus infinity, with the rest; denominator above 0.
struct FlooredQuotient {
    std::int64_t quotient, rest;

    FlooredQuotient(std::int64_t numerator, std::int64_t denominator)
        : quotient(numerator / denominator), rest(numerator % denominator) {
        if (rest >= 0) return;
        rest += denominator;
        --quotient;
    }
};

/// Steps down an edge a row at a time, always at the first column whose centre lies at or right of it.
/// With the edge from `top` to `bottom`, dy > 0, the column of row r is
///     ceil(((top.x - 128) dy + (256 r + 128 - top.y) dx) / (256 dy)),
/// kept as a quotient and a rest, so that no step loses anything. |coordinates| <= 2^28: numerators stay below 2^60.
class EdgeWalker {
  public:
    EdgeWalker(ScreenVertex top, ScreenVertex bottom, std::int32_t row) {
        const std::int64_t dx = std::int64_t{bottom.x.raw} - top.x.raw, dy = std::int64_t{bottom.y.raw} - top.y.raw;
        whole_ = 256 * dy;
        const std::int64_t down = std::int64_t{row} * 256 + 128 - top.y.raw;
        const std::int64_t numerator = (std::int64_t{top.x.raw} - 128) * dy + down * dx + whole_ - 1;
        note_range<Quantity::EdgeNumerator>(numerator);
        const FlooredQuotient start(numerator, whole_);
        const FlooredQuotient slope(dx, dy);
        column_ = start.quotient;
        rest_ = start.rest;
        step_ = slope.quotient;
        step_rest_ = slope.rest * 256;
    }

    std::int32_t column() const { return static_cast<std::int32_t>(column_); }

    void next_row() {
        column_ += step_;
        rest_ += step_rest_;
        note_range<Quantity::EdgeRest>(rest_);
        const std::int64_t carry = rest_ >= whole_;
        column_ += carry;
        rest_ -= whole_ & -carry;
    }

  private:
    std::int64_t whole_, column_, rest_, step_, step_rest_;
};

struct RowRange {
    std::int32_t first, end;
};

RowRange rows_between(Screen top, Screen bottom, std::int32_t height) {
    return {std::max(first_centre_from(top.raw), 0), std::min(first_centre_from(bottom.raw), height)};
}

void walk_edge(ScreenVertex top, ScreenVertex bottom, std::vector<std::int32_t>& columns) {
    const RowRange range = rows_between(top.y, bottom.y, static_cast<std::int32_t>(columns.size()));
    if (range.first >= range.end) return;
    EdgeWalker walker(top, bottom, range.first);
    std::int32_t* out = columns.data();
    for (std::int32_t row = range.first; row < range.end; ++row, walker.next_row()) out[row] = walker.column();
}

/// Like walk_edge, but several edges of one side may cross a row: the outermost counts.
void widen_by_edge(ScreenVertex top, ScreenVertex bottom, std::vector<std::int32_t>& columns, bool is_left) {
    const RowRange range = rows_between(top.y, bottom.y, static_cast<std::int32_t>(columns.size()));
    if (range.first >= range.end) return;
    EdgeWalker walker(top, bottom, range.first);
    for (std::int32_t row = range.first; row < range.end; ++row, walker.next_row()) {
        std::int32_t& column = columns[static_cast<std::size_t>(row)];
        column = is_left ? std::min(column, walker.column()) : std::max(column, walker.column());
    }
}

ScreenVertex within_limits(ScreenVertex v) {
    return {Screen::from_raw(std::clamp(v.x.raw, -kLargestScreen_8, kLargestScreen_8)),
            Screen::from_raw(std::clamp(v.y.raw, -kLargestScreen_8, kLargestScreen_8))};
}

/// What a polygon looks like before it is scanned.
struct Profile {
    std::int32_t first_row, end_row;
    bool is_monotone;  ///< goes down once and up once, as convex polygons do
};

Profile survey(std::span<const ScreenVertex> vertices, std::int32_t height) {
    std::int32_t top = std::numeric_limits<std::int32_t>::max(), bottom = std::numeric_limits<std::int32_t>::min();
    int turns = 0, direction = 0, first_direction = 0;
    ScreenVertex from = vertices.back();
    for (const ScreenVertex& to : vertices) {
        top = std::min(top, to.y.raw);
        bottom = std::max(bottom, to.y.raw);
        const int now = (to.y.raw > from.y.raw) - (to.y.raw < from.y.raw);
        from = to;
        if (now == 0) continue;
        if (first_direction == 0) first_direction = now;
        turns += direction != 0 && now != direction;
        direction = now;
    }
    turns += direction != first_direction;
    top = std::min(top, kLargestScreen_8);
    bottom = std::min(bottom, kLargestScreen_8);
    return {std::max(first_centre_from(top), 0), std::min(first_centre_from(bottom), height), turns <= 2};
}

/// Snapping and clipping can bend a chain of nearly collinear vertices back by a step. Such a polygon is widened to its
/// outermost edges: its neighbours, which share them, may be overlapped by a sliver, but no gap can open.
void scan_bent(std::span<const ScreenVertex> vertices, ScanlineExtents& rows) {
    for (std::int32_t row = rows.first; row < rows.end; ++row) {
        rows.left[static_cast<std::size_t>(row)] = std::numeric_limits<std::int32_t>::max();
        rows.right[static_cast<std::size_t>(row)] = std::numeric_limits<std::int32_t>::min();
    }
    ScreenVertex from = within_limits(vertices.back());
    for (const ScreenVertex& vertex : vertices) {
        const ScreenVertex to = within_limits(vertex);
        if (from.y < to.y) widen_by_edge(from, to, rows.right, false);
        if (to.y < from.y) widen_by_edge(to, from, rows.left, true);
        from = to;
    }
}

}  // namespace

void scan_convex(std::span<const ScreenVertex> vertices, ScanlineExtents& rows) {
    rows.first = rows.end = 0;
    if (vertices.size() < 3) return;
    const Profile profile = survey(vertices, static_cast<std::int32_t>(rows.left.size()));
    rows.first = profile.first_row;
    rows.end = profile.end_row;
    if (rows.first >= rows.end) return;
    if (!profile.is_monotone) return scan_bent(vertices, rows);

    ScreenVertex from = within_limits(vertices.back());
    for (const ScreenVertex& vertex : vertices) {
        const ScreenVertex to = within_limits(vertex);
        if (from.y < to.y) walk_edge(from, to, rows.right);
        if (to.y < from.y) walk_edge(to, from, rows.left);
        from = to;
    }
}

std::int64_t doubled_area_16(std::span<const ScreenVertex> vertices) {
    std::int64_t sum = 0;
    ScreenVertex from = vertices.back();
    for (const ScreenVertex& to : vertices) {
        sum += std::int64_t{from.x.raw} * to.y.raw - std::int64_t{to.x.raw} * from.y.raw;
        from = to;
    }
    return sum;
}

}  // namespace oblong

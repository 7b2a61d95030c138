#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "engine/base/range_probe.h"
#include "engine/fixed/divide.h"
#include "engine/raster/scan.h"
#include "engine/view/gradients.h"
#include "engine/view/screen.h"

namespace oblong {

/// Steps down an edge row by row, to the first column whose centre is on or right of the edge. For the edge from `top`
/// to `bottom`, dy > 0, the column of row r is
///     ceil(((top.x - 1/2) dy + (r + 1/2 - top.y) dx) / dy),
/// stored as quotient and remainder, so that every step is exact. |coordinates| <= 2^20: numerators stay below 2^60.
class ExactWalker {
  public:
    ExactWalker(ScreenVertex top, ScreenVertex bottom, std::int32_t row) {
        const ScreenWide dx = widening_difference(bottom.x, top.x), dy = widening_difference(bottom.y, top.y);
        const ScreenWide across = widening_difference(top.x, kHalfPixel),
                         down = widening_difference(Screen::from_int(row), top.y - kHalfPixel);
        // dy times one pixel, in the format of the numerator.
        const ScreenArea divisor = bounded_product(ScreenWide::from_int(1), dy);
        const ScreenArea numerator =
            bounded_product(across, dy) + bounded_product(down, dx) + divisor - ScreenArea::ulp();
        const FlooredDivision start = floored_division(numerator.raw, divisor.raw);
        const FlooredDivision slope = floored_division(dx.raw, dy.raw);
        divisor_ = divisor.raw;
        column_ = start.quotient;
        remainder_ = start.remainder;
        step_ = slope.quotient;
        step_remainder_ = slope.remainder * 256;
    }

    std::int32_t column() const { return static_cast<std::int32_t>(column_); }

    void next_row() {
        column_ += step_;
        remainder_ += step_remainder_;
        const std::int64_t carry = remainder_ >= divisor_;
        column_ += carry;
        remainder_ -= divisor_ & -carry;
    }

  private:
    std::int64_t divisor_, column_, remainder_, step_, step_remainder_;
};

/// The same columns for edges on a screen (coordinates from 0 to kLargestMode_px), with one division, and one addition
/// a row: slope and position have 41 fraction bits, both rounded down. Why this is exact: an edge of height dy, in
/// 1/256 pixel, crosses the centres of rows at multiples of 1 / (256 dy) pixel, which is at least 2^-28. The slope is
/// less than 2^-41 too small, so after 4,096 rows the position is less than 2^-28 too far left: if it is right of a
/// column's centre, it stays right of it.
class ScreenWalker {
  public:
    ScreenWalker(ScreenVertex top, ScreenVertex bottom, std::int32_t row) {
        const ScreenWide dx = widening_difference(bottom.x, top.x), dy = widening_difference(bottom.y, top.y);
        const ScreenWide across = widening_difference(top.x, kHalfPixel),
                         down = widening_difference(Screen::from_int(row), top.y - kHalfPixel);
        const auto dividend = convert<Fixed<std::int64_t, 49>>(dx);
        slope_ = Column::from_raw(floored_division(dividend.raw, dy.raw).quotient);
        const auto way = bounded_product(slope_, down);  // within dx, as the edge crosses the row
        note_range<"edge slope's dividend">(dividend);
        note_range<"edge's way to its first row">(way);
        column_ = convert<Column>(across) + convert<Column>(way, Rounding::Floor) + Column::from_int(1) - Column::ulp();
    }

    std::int32_t column() const { return static_cast<std::int32_t>(floor_of(column_)); }
    void next_row() { column_ += slope_; }
    ScreenWalker after(std::int32_t rows) const {
        ScreenWalker further = *this;
        further.column_ += slope_ * rows;
        return further;
    }

    static constexpr int kFractionBits = 41;
    using Column = Fixed<std::int64_t, kFractionBits>;
    Column slope() const { return slope_; }

  private:
    Column slope_, column_;
};

/// An edge directed downward, on one side of its polygon.
struct SideEdge {
    bool is_right;
    ScreenVertex top, bottom;

    SideEdge(ScreenVertex from, ScreenVertex to)
        : is_right(from.y < to.y), top(is_right ? from : to), bottom(is_right ? to : from) {}
    PixelRange rows(PixelRange within) const {
        return {std::max(first_centre_from(top.y), within.first), std::min(first_centre_from(bottom.y), within.end)};
    }
};

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

#pragma once

#include <cstdint>

#include "engine/base/range_probe.h"
#include "engine/raster/scan.h"

namespace oblong {

/// numerator / denominator toward minus infinity, with the remainder; denominator above 0.
struct FlooredQuotient {
    std::int64_t quotient, rest;

    template <int Frac>
    FlooredQuotient(Fixed<std::int64_t, Frac> numerator, Fixed<std::int64_t, Frac> denominator)
        : quotient(numerator.raw / denominator.raw), rest(numerator.raw % denominator.raw) {
        if (rest >= 0) return;
        rest += denominator.raw;
        --quotient;
    }
};

/// Steps down an edge a row at a time, always at the first column whose centre lies at or right of it.
/// With the edge from `top` to `bottom`, dy > 0, the column of row r is
///     ceil(((top.x - 1/2) dy + (r + 1/2 - top.y) dx) / dy),
/// kept as a quotient and a remainder, so that every step is exact. |coordinates| <= 2^20: numerators stay below 2^60.
class ExactWalker {
  public:
    ExactWalker(ScreenVertex top, ScreenVertex bottom, std::int32_t row) {
        constexpr auto kHalf = Screen::from_raw(128);
        const ScreenWide dx = widening_difference(bottom.x, top.x), dy = widening_difference(bottom.y, top.y);
        const ScreenWide across = widening_difference(top.x, kHalf),
                         down = widening_difference(Screen::from_int(row), top.y - kHalf);
        const ScreenArea whole = bounded_product(ScreenWide::from_int(1), dy);
        const ScreenArea numerator =
            bounded_product(across, dy) + bounded_product(down, dx) + whole - ScreenArea::ulp();
        note_range<"edge numerator">(numerator);
        const FlooredQuotient start(numerator, whole);
        const FlooredQuotient slope(dx, dy);
        whole_ = whole.raw;
        column_ = start.quotient;
        rest_ = start.rest;
        step_ = slope.quotient;
        step_rest_ = slope.rest * 256;
    }

    std::int32_t column() const { return static_cast<std::int32_t>(column_); }

    void next_row() {
        column_ += step_;
        rest_ += step_rest_;
        note_range<"edge rest">(ScreenArea::from_raw(rest_));
        const std::int64_t carry = rest_ >= whole_;
        column_ += carry;
        rest_ -= whole_ & -carry;
    }

  private:
    std::int64_t whole_, column_, rest_, step_, step_rest_;
};

}  // namespace oblong

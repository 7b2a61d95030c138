#include <algorithm>
#include <cstdint>

#include "engine/raster/texture_blocks.h"

namespace oblong {

namespace {

/// A linear quantity over a rectangle of the screen: its value at the first pixel, and its change over all columns and
/// over all rows.
struct Slopes {
    std::int64_t first, columns, rows;

    std::int64_t least() const { return first + std::min<std::int64_t>(columns, 0) + std::min<std::int64_t>(rows, 0); }
    std::int64_t greatest() const { return -Slopes{-first, -columns, -rows}.least(); }
};

template <class Value>
Slopes slopes_over(const ScreenRectangle& rectangle, const LinearQuantity<Value>& quantity) {
    const auto columns = static_cast<std::uint32_t>(rectangle.end_column - rectangle.first_column - 1);
    const auto rows = static_cast<std::uint32_t>(rectangle.end_row - rectangle.first_row - 1);
    return {quantity.at_shown(rectangle.first_column, rectangle.first_row).raw,
            stepped(Value{}, quantity.per_column, columns).raw, stepped(Value{}, quantity.per_row, rows).raw};
}

/// Whether |over_z| is below 7 times 1/z everywhere, both in raw steps.
inline bool is_below_7_times(const Slopes& over_z, const Slopes& z) {
    return Slopes{7 * z.first - over_z.first, 7 * z.columns - over_z.columns, 7 * z.rows - over_z.rows}.least() > 0 &&
           Slopes{7 * z.first + over_z.first, 7 * z.columns + over_z.columns, 7 * z.rows + over_z.rows}.least() > 0;
}

/// Whether sums over the rectangle cannot overflow: over 4,096 columns and rows the steps add up to less than 2^57. A
/// small first value has not wrapped, as values inside the polygon, less than 2^57 away, fit their format.
template <class Value>
bool is_gentle(const LinearQuantity<Value>& quantity, const Slopes& slopes) {
    constexpr Value kSteepest = Value::from_raw(std::int64_t{1} << 44),
                    kLargest = Value::from_raw(std::int64_t{1} << 59);
    return is_within(quantity.per_column, kSteepest) && is_within(quantity.per_row, kSteepest) &&
           is_within(Value::from_raw(slopes.first), kLargest);
}

}  // namespace

bool fits_range(const TextureGradients& gradients, const ScreenRectangle& rectangle) {
    const Slopes z = slopes_over(rectangle, gradients.inverse_z);
    const Slopes u = slopes_over(rectangle, gradients.u_over_z), v = slopes_over(rectangle, gradients.v_over_z);
    return is_gentle(gradients.inverse_z, z) && is_gentle(gradients.u_over_z, u) && is_gentle(gradients.v_over_z, v) &&
           InverseZ::from_raw(z.least()) >= kLeastFittingInverseZ &&
           InverseZ::from_raw(z.greatest()) < kGreatestInverseZ && is_below_7_times(u, z) && is_below_7_times(v, z);
}

InverseZ least_inverse_z(const LinearQuantity<InverseZ>& inverse_z, const ScreenRectangle& rectangle) {
    return InverseZ::from_raw(slopes_over(rectangle, inverse_z).least());
}

}  // namespace oblong

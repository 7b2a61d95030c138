#include "engine/view/gradients.h"

#include "engine/fixed/arithmetic.h"

namespace oblong {

namespace {

LinearQuantity<DirectionPart> part_of(Unit right, Unit up, Unit forward, const Projection& projection) {
    const auto per_pixel = [](Unit axis, Multiplier multiplier) {
        return divide<DirectionPart>(axis, multiplier, Rounding::Floor);
    };
    const DirectionPart per_column = per_pixel(right, projection.x.multiplier);
    const DirectionPart per_row = -per_pixel(up, projection.y.multiplier);
    const auto to_first = [](DirectionPart step, std::int32_t size_px) { return floor_shift(step * (1 - size_px), 1); };
    const DirectionPart middle = DirectionPart::from_raw(forward.raw);
    return {middle + to_first(per_column, projection.width_px) + to_first(per_row, projection.height_px), per_column,
            per_row};
}

}  // namespace

ViewDirections make_view_directions(const Basis& axes, const Projection& projection) {
    return {part_of(axes.right.x, axes.up.x, axes.forward.x, projection),
            part_of(axes.right.y, axes.up.y, axes.forward.y, projection),
            part_of(axes.right.z, axes.up.z, axes.forward.z, projection)};
}

}  // namespace oblong

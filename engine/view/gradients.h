#pragma once

#include <cstdint>

#include "engine/fixed/fixed.h"
#include "engine/math/basis.h"
#include "engine/view/projection.h"

namespace oblong {

/// A quantity that is linear on the screen: its value at the centre of pixel (0, 0), and its steps per pixel.
/// Intermediate sums may wrap; values inside the polygon fit.
template <class Value>
struct LinearQuantity {
    Value origin, per_column, per_row;

    Value at(std::int32_t column, std::int32_t row) const {
        return stepped(stepped(origin, per_column, column), per_row, row);
    }
    /// The same for column, row >= 0: with unsigned factors, i386 needs two 32-bit products for one of 64 bits, not
    /// three.
    [[gnu::always_inline]] Value at_shown(std::int32_t column, std::int32_t row) const {
        return stepped(stepped(origin, per_column, static_cast<std::uint32_t>(column)), per_row,
                       static_cast<std::uint32_t>(row));
    }
};

/// The screen gradients of a textured plane (z in world units, u and v in texels of the mip level). Errors:
/// engine/fixed/README.md.
struct TextureGradients {
    LinearQuantity<InverseZ> inverse_z;
    LinearQuantity<TexelOverZ> u_over_z, v_over_z;
};

/// Rounds to fewer fraction bits, as in narrower accumulators.
template <class Value>
LinearQuantity<Value> rounded_to(const LinearQuantity<Value>& quantity, int fraction_bits) {
    return {rounded_to(quantity.origin, fraction_bits), rounded_to(quantity.per_column, fraction_bits),
            rounded_to(quantity.per_row, fraction_bits)};
}

inline TextureGradients rounded_to(const TextureGradients& gradients, int inverse_z_bits, int over_z_bits) {
    return {rounded_to(gradients.inverse_z, inverse_z_bits), rounded_to(gradients.u_over_z, over_z_bits),
            rounded_to(gradients.v_over_z, over_z_bits)};
}

/// A component of a direction of view: 34.30.
using DirectionPart = Fixed<std::int64_t, 30>;

/// The directions through pixel centres in world axes, scaled to a depth of one unit: linear on the screen.
struct ViewDirections {
    LinearQuantity<DirectionPart> x, y, z;

    Vec3<DirectionPart> at(std::int32_t column, std::int32_t row) const {
        return {x.at(column, row), y.at(column, row), z.at(column, row)};
    }
};

ViewDirections make_view_directions(const Basis& axes, const Projection& projection);

}  // namespace oblong

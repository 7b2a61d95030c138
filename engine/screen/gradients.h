#pragma once

#include <cstdint>

#include "engine/fixed/fixed.h"

namespace oblong {

/// A quantity that is linear on the screen: its value at the centre of pixel (0, 0) and its steps per pixel.
/// Intermediate sums may wrap; values inside the polygon fit.
template <class Value>
struct LinearQuantity {
    Value origin, per_column, per_row;

    Value at(std::int32_t column, std::int32_t row) const {
        return stepped(stepped(origin, per_column, column), per_row, row);
    }
};

/// The screen gradients of a textured plane (z in world units, u and v in texels of the mip level in use). Errors:
/// engine/fixed/README.md.
struct TextureGradients {
    LinearQuantity<InverseZ> inverse_z;
    LinearQuantity<TexelOverZ> u_over_z, v_over_z;
};

}  // namespace oblong

#pragma once

#include <cstdint>

#include "engine/fixed/fixed.h"

namespace oblong {

/// A quantity that is linear on the screen: its value at the centre of pixel (0, 0) and its steps per pixel. Sums may
/// wrap on the way: what counts is the value inside the polygon, and that fits.
template <class Value>
struct LinearQuantity {
    Value origin, per_column, per_row;

    Value at(std::int32_t column, std::int32_t row) const {
        return stepped(stepped(origin, per_column, column), per_row, row);
    }
};

/// How a plane's texture lies on the screen (z in world units, u and v in texels of the mip level in use). The budget:
/// engine/fixed/README.md.
struct TextureGradients {
    LinearQuantity<InverseZ> inverse_z;
    LinearQuantity<TexelOverZ> u_over_z, v_over_z;
};

}  // namespace oblong

#pragma once

#include <cstdint>

namespace oblong {

/// A quantity that is linear on the screen: its value at the centre of pixel (0, 0) and its steps per pixel. Stored
/// unsigned, since sums may wrap on the way: what counts is the value inside the polygon, and that fits 64 bits signed.
struct LinearQuantity {
    std::uint64_t origin = 0, per_column = 0, per_row = 0;

    std::int64_t at(std::int32_t column, std::int32_t row) const {
        return static_cast<std::int64_t>(origin + per_column * static_cast<std::uint64_t>(std::int64_t{column}) +
                                         per_row * static_cast<std::uint64_t>(std::int64_t{row}));
    }
};

/// How a plane's texture lies on the screen: 1/z with 44 fraction bits (z in world units), u/z and v/z with 30 (u, v in
/// texels of the mip level in use). The budget: engine/fixed/README.md.
struct TextureGradients {
    LinearQuantity inverse_z_44, u_over_z_30, v_over_z_30;
};

}  // namespace oblong

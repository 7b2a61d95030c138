#pragma once

#include "engine/view/gradients.h"
#include "engine/view/screen.h"

namespace oblong {

/// 1/z is clamped to these: z from 2^-15 unit to beyond any world.
inline constexpr auto kGreatestInverseZ = InverseZ::from_raw(std::int64_t{1} << 59);
inline constexpr auto kLeastInverseZ = InverseZ::from_raw(std::int64_t{1} << 24);

/// Whether 1/z is within its limits and |u|, |v| are below 114,000 texels at every pixel of a rectangle around a
/// polygon's spans: then cutters give the same results without clamping. The quantities are linear, so their extremes
/// are at the corners.
bool fits_range(const TextureGradients& gradients, const ScreenRectangle& rectangle);

/// The least 1/z in the rectangle.
InverseZ least_inverse_z(const LinearQuantity<InverseZ>& inverse_z, const ScreenRectangle& rectangle);

}  // namespace oblong

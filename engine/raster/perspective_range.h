#pragma once

#include "engine/view/gradients.h"
#include "engine/view/screen.h"

namespace oblong {

/// 1/z is clamped to these: the largest is that of z = 2^-15 unit, the smallest that of a point beyond any world.
inline constexpr auto kGreatestInverseZ = InverseZ::from_raw(std::int64_t{1} << 59);
inline constexpr auto kLeastInverseZ = InverseZ::from_raw(std::int64_t{1} << 24);

/// Whether 1/z is within its clamps, and u and v within 114,000 texels, at every pixel of a rectangle around the spans
/// of a polygon; only then do the cutters give the same without clamps. All three are linear: their extremes are in the
/// corners.
bool fits_range(const TextureGradients& gradients, const ScreenRectangle& rectangle);

/// The least 1/z in such a rectangle.
InverseZ least_inverse_z(const LinearQuantity<InverseZ>& inverse_z, const ScreenRectangle& rectangle);

}  // namespace oblong

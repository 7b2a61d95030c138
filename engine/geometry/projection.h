#pragma once

#include <cstdint>

#include "engine/base/range_probe.h"
#include "engine/fixed/angle.h"
#include "engine/fixed/fixed.h"
#include "engine/fixed/wide.h"
#include "engine/screen/screen_mode.h"

namespace oblong {

/// A screen position that need not be on the screen: 56.8.
using ScreenWide = Fixed<std::int64_t, 8>;

/// One axis of the projection: screen = centre + multiplier * view / view_z.
struct ProjectionAxis {
    Multiplier multiplier;    ///< pixels; precomputed once for a mode and a field of view
    std::int64_t coarse_16;   ///< the same with 16 fraction bits, for what is near the screen
    std::int64_t fast_limit;  ///< |view| below this: view * coarse_16 fits 62 bits
    ScreenWide centre;        ///< the optical centre, pixels
};

/// The two precomputed multipliers of Muratori's projection: aspect and field of view enter here and nowhere
/// else.
struct Projection {
    ProjectionAxis x, y;  ///< y's multiplier is positive: project() turns it, since rows grow downward
    std::int32_t width_px = 0, height_px = 0;
};

/// d = (width / 2) / tan(fov / 2); x: d, y: d * display * height / width. Without `correct_aspect` y takes x's
/// multiplier, as if pixels were square. `field_of_view` is above 0 and below 180 degrees; the multipliers are right to
/// 2^-32 pixel for fields of view from 1 to 179 degrees.
Projection make_projection(const ScreenMode& mode, Degrees field_of_view, bool correct_aspect = true);

/// Whether frames can be drawn by it: multipliers of at least half a pixel, or their reciprocals do not fit what
/// gradients are made of. At 179 degrees on 4:3 that takes 115x86 pixels, at 90 degrees any mode of 4:3 will do.
bool is_drawable(const Projection& projection);

/// project_axis_8() where a 64-bit product won't do.
std::int64_t project_axis_wide_8(const ProjectionAxis& axis, std::int64_t view_16, std::int64_t z_16);

/// multiplier * view / z, rounded to the nearest 1/256 pixel. z above 0. Near the screen (|view| <= 64 z) the
/// multiplier has 16 fraction bits, so that a 64-bit product does, and is off by no more than 64 * 2^-17 pixel. Beyond,
/// the exact quotient, held back from what the other gives where they meet. So all depends on view / z alone and never
/// steps back where that grows.
inline std::int64_t project_axis_8(const ProjectionAxis& axis, std::int64_t view_16, std::int64_t z_16) {
    const std::int64_t size = view_16 < 0 ? -view_16 : view_16;
    if (size >= axis.fast_limit || size > z_16 * 64) return project_axis_wide_8(axis, view_16, z_16);
    const std::int64_t numerator = view_16 * axis.coarse_16 + z_16 * 128;
    const std::int64_t denominator = z_16 * 256;
    note_range<Quantity::ProjectionNumerator>(numerator);
    const std::int64_t quotient = numerator / denominator;
    return quotient - (numerator % denominator < 0);
}

}  // namespace oblong

#pragma once

#include <cstdint>
#include <optional>

#include "engine/base/range_probe.h"
#include "engine/fixed/angle.h"
#include "engine/fixed/arithmetic.h"
#include "engine/fixed/divide.h"
#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"
#include "engine/view/screen.h"

namespace oblong {

/// A multiplier with fewer bits: pixels, 48.16.
using CoarseMultiplier = Fixed<std::int64_t, 16>;

/// One axis of the projection: screen = centre + multiplier * view / view_z.
struct ProjectionAxis {
    Multiplier multiplier;    ///< pixels; precomputed once for a mode and a field of view
    CoarseMultiplier coarse;  ///< the same for points near the screen
    View fast_limit;          ///< |view| below this: view * coarse fits 62 bits
    ScreenWide centre;        ///< the optical centre, pixels
};

/// The two precomputed multipliers of Muratori's projection: aspect and field of view enter here and nowhere
/// else.
struct Projection {
    ProjectionAxis x, y;  ///< y's multiplier is positive: project() turns it, since rows grow downward
    std::int32_t width_px = 0, height_px = 0;
};

/// The part of the view plane that the screen shows, in any common unit: half its width and its distance from the
/// eye, whose ratio is tan(field of view / 2). With a `half_height` the window is shown whole, whatever its shape: on a
/// screen of another shape there is more around it, and never another scale across than down.
struct ViewWindow {
    View half_width, distance;
    View half_height = {};  ///< 0: as the display's shape gives it
    constexpr bool operator==(const ViewWindow&) const = default;
};

/// Half the width of what a screen of this shape shows of the world around a window, in the window's unit.
View shown_half_width(const ViewWindow& window, const ScreenMode& mode);

/// d = (width / 2) * distance / half_width, or less where the height asks for it; for y see below. Parts above 0.
Projection make_projection(const ScreenMode& mode, const ViewWindow& window, bool correct_aspect = true);

/// The window of a field of view across the whole width, above 0 and below 180 degrees.
ViewWindow window_of(Degrees field_of_view);

/// d = (width / 2) / tan(fov / 2); x: d, y: d * display * height / width. Without `correct_aspect` y takes x's
/// multiplier, as if pixels were square. `field_of_view` is above 0 and below 180 degrees; the multipliers are right to
/// 2^-32 pixel for fields of view from 1 to 179 degrees.
Projection make_projection(const ScreenMode& mode, Degrees field_of_view, bool correct_aspect = true);

/// Whether frames can be drawn with it: multipliers below half a pixel have reciprocals that do not fit the format used
/// for gradients. At 179 degrees on 4:3 that takes 115x86 pixels, at 90 degrees any mode of 4:3 will do.
bool is_drawable(const Projection& projection);

/// project_axis() where a 64-bit product would overflow.
ScreenWide project_axis_wide(const ProjectionAxis& axis, View view, View z);

#if defined(__i386__)
/// project_axis() of numbers of 32 bits: one product and one division, where others take function calls.
inline std::optional<ScreenWide> project_axis_in_32_bits(const ProjectionAxis& axis, View view, View z) {
    const auto short_view = static_cast<std::int32_t>(view.raw), short_z = static_cast<std::int32_t>(z.raw);
    if (short_view != view.raw || short_z != z.raw || axis.coarse.raw >= 1 << 29) return std::nullopt;
    const auto sign = static_cast<std::uint32_t>(short_view >> 31), depth = static_cast<std::uint32_t>(short_z);
    const std::uint32_t size = (static_cast<std::uint32_t>(short_view) ^ sign) - sign;
    if ((size + 63) / 64 > depth) return std::nullopt;
    const std::uint64_t numerator = std::uint64_t{size} * static_cast<std::uint32_t>(axis.coarse.raw);
    // Halves of steps, a half of one more toward plus infinity: that of 2.5 is 3, that of -2.5 is -2.
    const ShortDivision halves = divide_to_32(numerator >> 7, depth);
    if (sign == 0) return ScreenWide::from_raw(static_cast<std::int32_t>((halves.quotient + 1) / 2));
    const bool is_exact = (halves.remainder | (numerator & 127)) == 0;
    return ScreenWide::from_raw(-static_cast<std::int32_t>((halves.quotient + (is_exact ? 0 : 1)) / 2));
}
#endif

/// multiplier * view / z, rounded to the nearest 1/256 pixel. z above 0. Near the screen (|view| <= 64 z) the
/// multiplier has 16 fraction bits, so that a 64-bit product fits; the error is at most 64 * 2^-17 pixel. Beyond, the
/// exact quotient, but never nearer to the centre than the other method's result where they meet. So the result depends
/// on view / z alone and is monotonic in it.
inline ScreenWide project_axis(const ProjectionAxis& axis, View view, View z) {
#if defined(__i386__)
    if (const auto near = project_axis_in_32_bits(axis, view, z)) return *near;
#endif
    const View size = absolute(view);
    if (size >= axis.fast_limit || size > z * 64) return project_axis_wide(axis, view, z);
    const auto numerator = bounded_product(view, axis.coarse);
    note_range<"projection numerator">(numerator);
    return bounded_quotient<ScreenWide>(numerator, z);
}

/// Eye, orientation, horizontal field of view. Yaw counter-clockwise from +x seen from above, pitch positive looking
/// down, roll positive leaning right (Quake's).
struct Camera {
    Vec3<World> eye;
    Angle yaw, pitch, roll;
    Degrees field_of_view = Degrees::from_int(90);  ///< across the whole width; 1 to 179
};

}  // namespace oblong

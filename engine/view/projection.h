#pragma once

#include <cstdint>
#include <optional>

#include "engine/base/range_probe.h"
#include "engine/fixed/arithmetic.h"
#include "engine/fixed/divide.h"
#include "engine/fixed/fixed.h"
#include "engine/fixed/native/native.h"
#include "engine/fixed/trig.h"
#include "engine/math/vec.h"
#include "engine/view/screen.h"

namespace oblong {

/// A multiplier with fewer fraction bits, pixels: 48.16.
using CoarseMultiplier = Fixed<std::int64_t, 16>;

/// One axis of the projection: screen = centre + multiplier * view / view_z.
struct ProjectionAxis {
    Multiplier multiplier;    ///< pixels; computed once for a mode and a field of view
    CoarseMultiplier coarse;  ///< the same for points near the screen
    View fast_limit;          ///< if |view| is below this, view * coarse fits 62 bits
    ScreenWide centre;        ///< the optical centre, pixels
};

/// The two multipliers of Muratori's projection. Aspect and field of view are used here and nowhere else.
struct Projection {
    ProjectionAxis x, y;  ///< y's multiplier is positive; project() negates y, as rows grow downward
    std::int32_t width_px = 0, height_px = 0;
    std::uint32_t short_z_end = 0;  ///< where projections in 32 bits end; 0 if multipliers are too large for them
};

/// The part of the view plane that the screen shows, in any unit: half its width and its distance from the eye, whose
/// ratio is tan(field of view / 2). With a `half_height` the whole window is shown: on a screen of another shape more
/// is visible around it, and the scale stays equal in both directions.
struct ViewWindow {
    View half_width, distance;
    View half_height = {};  ///< 0: from the display's shape
    constexpr bool operator==(const ViewWindow&) const = default;
};

/// Half the width shown on a screen of the mode's shape, in the window's unit.
View shown_half_width(const ViewWindow& window, const ScreenMode& mode);

/// The multiplier of x is d = (width / 2) * distance / shown_half_width(), that of y d * display * height / width.
/// Without `correct_aspect` both are d, as if pixels were square. The window's members are above 0.
Projection make_projection(const ScreenMode& mode, const ViewWindow& window, bool correct_aspect = true);

/// The window of a horizontal field of view, above 0 and below 180 degrees.
ViewWindow window_of(Degrees field_of_view);

/// The same for a horizontal field of view, where d = (width / 2) / tan(field_of_view / 2): above 0 and below 180
/// degrees; from 1 to 179 degrees the multipliers are accurate to 2^-32 pixel.
Projection make_projection(const ScreenMode& mode, Degrees field_of_view, bool correct_aspect = true);

/// Whether frames can be drawn: reciprocals of multipliers below half a pixel do not fit the gradients' format. On 4:3,
/// 179 degrees need 115x86 pixels, 90 degrees work in any mode.
bool is_drawable(const Projection& projection);

/// project_axis() if a 64-bit product would overflow.
ScreenWide project_axis_wide(const ProjectionAxis& axis, View view, View z);

/// Whether a point's 32-bit numbers suffice for project_axis(): -64 z <= view < 64 z. z is below 2^30.
[[gnu::always_inline]] inline bool is_near_axis(std::int32_t view, std::uint32_t z) {
    return static_cast<std::uint32_t>(view >> 6) + z < 2 * z;
}

/// project_axis() of such a point, with a coarse multiplier below 2^26: one product and one division.
[[gnu::always_inline]] inline Screen project_near_axis(std::int32_t coarse, std::int32_t view, std::uint32_t z) {
    static_assert(CoarseMultiplier::kFractionBits - Screen::kFractionBits == 8);
    return Screen::from_raw(native::rounded_quotient_8(view, coarse, z));
}

[[gnu::always_inline]] inline std::optional<Screen> project_axis_in_32_bits(const ProjectionAxis& axis, View view,
                                                                            View z) {
    const auto short_view = static_cast<std::int32_t>(view.raw);
    const auto short_z = static_cast<std::uint32_t>(z.raw);
    if (short_view != view.raw || static_cast<std::uint64_t>(z.raw) >= 1u << 30 || axis.coarse.raw >= 1 << 26 ||
        !is_near_axis(short_view, short_z))
        return std::nullopt;
    return project_near_axis(static_cast<std::int32_t>(axis.coarse.raw), short_view, short_z);
}

/// multiplier * view / z, rounded to the nearest 1/256 pixel; z > 0. Near the screen (|view| <= 64 z) the multiplier
/// has 16 fraction bits, so that the product fits 64 bits; the error is at most 64 * 2^-17 pixel. Beyond, it is the
/// exact quotient, but not nearer to the centre than the first method's result at 64 z. So the result depends on view /
/// z only and is monotonic in it.
inline ScreenWide project_axis(const ProjectionAxis& axis, View view, View z) {
    if constexpr (native::kHasShortRegisters)
        if (const auto near = project_axis_in_32_bits(axis, view, z)) return convert<ScreenWide>(*near);
    const View size = absolute(view);
    if (size >= axis.fast_limit || size > z * 64) return project_axis_wide(axis, view, z);
    const auto numerator = bounded_product(view, axis.coarse);
    note_range<"projection numerator">(numerator);
    return bounded_quotient<ScreenWide>(numerator, z);
}

/// Yaw is counter-clockwise from +x seen from above, pitch positive looking down, roll positive leaning right (as in
/// Quake).
struct Camera {
    Vec3<World> eye;
    Angle yaw, pitch, roll;
    Degrees field_of_view = Degrees::from_int(90);  ///< horizontal; 1 to 179
};

}  // namespace oblong

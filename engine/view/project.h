#pragma once

#include <algorithm>

#include "engine/base/range_probe.h"
#include "engine/math/vec.h"
#include "engine/view/frustum.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"

namespace oblong {

/// The screen position of a point in viewspace, pixels, 56.8, rounded once to the nearest 1/256. On the screen the
/// error is at most 1/512 + 64 * 2^-17 pixel. z > 0, but may be rounded to 0 or less for a clipped corner next to the
/// eye.
struct ScreenPosition {
    ScreenWide x, y;
};

inline ScreenPosition project(const Vec3<View>& p, const Projection& projection) {
    const View z = std::max(p.z, View::ulp());
    return {projection.x.centre + project_axis(projection.x, p.x, z),
            projection.y.centre + project_axis(projection.y, -p.y, z)};
}

/// Rounds screen vertices to a number of fraction bits.
struct SubpixelGrid {
    std::int64_t half_step = 0, mask = -1;

    static constexpr SubpixelGrid of_bits(std::int32_t bits) {
        const std::int64_t step = std::int64_t{1} << (8 - bits);
        return {step / 2, -step};
    }
    constexpr ScreenWide snap(ScreenWide position) const {
        return ScreenWide::from_raw((position.raw + half_step) & mask);
    }
};

/// A clipped point as a screen vertex, snapped to the grid and clamped to [0, width] x [0, height], which only rounding
/// can exceed (hard case C7).
inline ScreenVertex to_screen_vertex(const ScreenPosition& position, const Projection& projection,
                                     const SubpixelGrid& grid) {
    const auto within = [&grid](ScreenWide along, std::int32_t size_px) {
        note_range<"screen position before clamping">(along);
        return convert<Screen>(std::clamp(grid.snap(along), ScreenWide{}, ScreenWide::from_int(size_px)));
    };
    return {within(position.x, projection.width_px), within(position.y, projection.height_px)};
}

/// Puts a corner that was clipped to `borders` of the view exactly on those of the screen.
inline ScreenVertex to_screen_border(ScreenVertex vertex, std::uint8_t borders, const Projection& projection) {
    if (borders == 0) return vertex;
    if (borders & kOutLeft) vertex.x = Screen{};
    if (borders & kOutRight) vertex.x = Screen::from_int(projection.width_px);
    if (borders & kOutBottom) vertex.y = Screen::from_int(projection.height_px);
    if (borders & kOutTop) vertex.y = Screen{};
    return vertex;
}

}  // namespace oblong

#pragma once

#include <algorithm>
#include <optional>

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
    std::int32_t half_step = 0, mask = -1;

    static constexpr SubpixelGrid of_bits(std::int32_t bits) {
        const std::int32_t step = 1 << (8 - bits);
        return {step / 2, -step};
    }
    constexpr Screen snap(Screen position) const { return Screen::from_raw((position.raw + half_step) & mask); }
};

/// A coordinate of a clipped point, clamped to [0, size], which only rounding can exceed (hard case C7), and snapped to
/// the grid, which has lines on these borders.
template <class Position>
Screen within_screen(Position along, std::int32_t size_px, const SubpixelGrid& grid) {
    note_range<"screen position before clamping">(along);
    return grid.snap(convert<Screen>(std::clamp(along, Position{}, Position::from_int(size_px))));
}

/// A position in viewspace within 2^15 units of the eye along each axis.
using ShortView = Fixed<std::int32_t, View::kFractionBits>;

/// project() in 32 bits, if these suffice, as for points inside the usual fields of view.
[[gnu::always_inline]] inline bool project_near(const Vec3<ShortView>& p, const Projection& projection,
                                                ScreenVertex& screen) {
    const auto z = static_cast<std::uint32_t>(p.z.raw);
    std::int32_t y = 0;
    if (z >= projection.short_z_end || __builtin_sub_overflow(0, p.y.raw, &y) || !is_near_axis(p.x.raw, z) ||
        !is_near_axis(y, z))
        return false;
    const auto along = [z](const ProjectionAxis& axis, std::int32_t view) {
        return convert<Screen>(axis.centre) + project_near_axis(static_cast<std::int32_t>(axis.coarse.raw), view, z);
    };
    screen = {along(projection.x, p.x.raw), along(projection.y, y)};
    return true;
}

/// Whether a point that project_near() has put there is certainly inside the frustum: a pixel or more from the borders
/// of the screen, as multipliers below 1,024 pixels keep the rounded planes within 2^-12 pixel of them.
[[gnu::always_inline]] inline bool is_well_inside(const ScreenVertex& screen, const Projection& projection) {
    const auto is_between = [](Screen at, std::int32_t size_px) {
        constexpr auto kPixel = Screen::from_int(1);
        return at >= kPixel && at <= Screen::from_int(size_px) - kPixel;
    };
    return is_between(screen.x, projection.width_px) && is_between(screen.y, projection.height_px);
}

/// None for points farther from the eye.
[[gnu::always_inline]] inline std::optional<Vec3<ShortView>> to_short(const Vec3<View>& p) {
    const Vec3<ShortView> near{ShortView::from_raw(static_cast<std::int32_t>(p.x.raw)),
                               ShortView::from_raw(static_cast<std::int32_t>(p.y.raw)),
                               ShortView::from_raw(static_cast<std::int32_t>(p.z.raw))};
    if (convert<View>(near) != p) return std::nullopt;
    return near;
}

/// A clipped point in viewspace as a screen vertex.
[[gnu::always_inline]] inline ScreenVertex to_screen_vertex(const Vec3<View>& p, const Projection& projection,
                                                            const SubpixelGrid& grid) {
    if constexpr (native::kHasShortRegisters) {
        ScreenVertex screen;
        if (const auto near = to_short(p); near && project_near(*near, projection, screen)) [[likely]]
            return {within_screen(screen.x, projection.width_px, grid),
                    within_screen(screen.y, projection.height_px, grid)};
    }
    const ScreenPosition position = project(p, projection);
    return {within_screen(position.x, projection.width_px, grid),
            within_screen(position.y, projection.height_px, grid)};
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

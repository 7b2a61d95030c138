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

#if defined(__i386__)
/// A position in viewspace within 2^15 units of the eye along each axis.
using ShortView = Fixed<std::int32_t, View::kFractionBits>;

/// to_screen_vertex() in 32 bits, if these suffice, as for points inside the usual fields of view.
[[gnu::always_inline]] inline bool to_near_screen_vertex(const Vec3<ShortView>& p, const Projection& projection,
                                                         const SubpixelGrid& grid, ScreenVertex& screen) {
    const auto& [axis_x, axis_y, width_px, height_px] = projection;
    const auto upper = [](auto number) { return static_cast<std::int32_t>(number.raw >> 32); };
    const auto z = static_cast<std::uint32_t>(p.z.raw);
    const auto coarse_x = static_cast<std::int32_t>(axis_x.coarse.raw),
               coarse_y = static_cast<std::int32_t>(axis_y.coarse.raw);
    const int beyond =
        static_cast<int>(z >> 30) | upper(axis_x.coarse) | upper(axis_y.coarse) | (coarse_x | coarse_y) >> 26;
    std::int32_t y = 0;
    if (beyond != 0 || __builtin_sub_overflow(0, p.y.raw, &y) || !is_near_axis(p.x.raw, z) || !is_near_axis(y, z))
        return false;
    screen = {within_screen(convert<Screen>(axis_x.centre) + project_near_axis(coarse_x, p.x.raw, z), width_px, grid),
              within_screen(convert<Screen>(axis_y.centre) + project_near_axis(coarse_y, y, z), height_px, grid)};
    return true;
}
#endif

#if defined(__i386__)
/// None for points farther from the eye.
[[gnu::always_inline]] inline std::optional<Vec3<ShortView>> to_short(const Vec3<View>& p) {
    const Vec3<ShortView> near{ShortView::from_raw(static_cast<std::int32_t>(p.x.raw)),
                               ShortView::from_raw(static_cast<std::int32_t>(p.y.raw)),
                               ShortView::from_raw(static_cast<std::int32_t>(p.z.raw))};
    if (convert<View>(near) != p) return std::nullopt;
    return near;
}
#endif

/// A clipped point in viewspace as a screen vertex.
[[gnu::always_inline]] inline ScreenVertex to_screen_vertex(const Vec3<View>& p, const Projection& projection,
                                                            const SubpixelGrid& grid) {
#if defined(__i386__)
    ScreenVertex screen;
    if (const auto near = to_short(p); near && to_near_screen_vertex(*near, projection, grid, screen)) [[likely]]
        return screen;
#endif
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

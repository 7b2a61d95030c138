#include "engine/geometry/project.h"

#include <algorithm>

#include "engine/base/range_probe.h"

namespace oblong {

namespace {

Screen snap_within(ScreenWide position, std::int32_t size_px, const SubpixelGrid& grid) {
    const std::int64_t limit = std::int64_t{size_px} * 256;
    note_range<Quantity::ScreenPosition>(position.raw);
    return Screen::from_raw(static_cast<std::int32_t>(std::clamp(grid.snap_8(position.raw), std::int64_t{0}, limit)));
}

}  // namespace

ScreenVertex to_screen_vertex(const ScreenPosition& position, const Projection& projection, const SubpixelGrid& grid) {
    return {snap_within(position.x, projection.width_px, grid), snap_within(position.y, projection.height_px, grid)};
}

ScreenVertex to_screen_border(ScreenVertex vertex, std::uint8_t borders, const Projection& projection) {
    if (borders & kOutLeft) vertex.x = Screen{};
    if (borders & kOutRight) vertex.x = Screen::from_int(projection.width_px);
    if (borders & kOutBottom) vertex.y = Screen::from_int(projection.height_px);
    if (borders & kOutTop) vertex.y = Screen{};
    return vertex;
}

}  // namespace oblong

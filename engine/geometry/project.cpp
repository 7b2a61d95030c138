#include "engine/geometry/project.h"

#include <algorithm>

#include "engine/base/range_probe.h"

namespace oblong {

namespace {

Screen snap_within(ScreenWide position, std::int32_t size_px, const SubpixelGrid& grid) {
    note_range<"screen position before clamping">(position);
    return convert<Screen>(std::clamp(grid.snap(position), ScreenWide{}, ScreenWide::from_int(size_px)));
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

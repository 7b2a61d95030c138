#include "engine/visibility/box_rectangle.h"

#include <algorithm>

namespace oblong {

namespace {

/// The box's extent along one axis of the view, 48.16.
struct Extent {
    std::int64_t least_16, greatest_16;
};

Extent extent_along(const Vec3<Unit>& axis, std::int64_t middle_16, const Vec3<World>& half) {
    const auto reach = [](Unit component, World size) {
        const std::int64_t product = std::int64_t{component.raw} * size.raw;
        return product < 0 ? -product : product;
    };
    const std::int64_t reach_42 = reach(axis.x, half.x) + reach(axis.y, half.y) + reach(axis.z, half.z);
    const std::int64_t reach_16 = floor_shift(reach_42, 26) + 2;
    return {middle_16 - reach_16, middle_16 + reach_16};
}

/// Pixels, from the screen's left or top.
struct PixelRange {
    std::int32_t first, end;
};

/// Where an extent lies on one axis of the screen: each end is farthest out where z is least, or nearest the centre
/// where it is greatest.
PixelRange project_extent(const ProjectionAxis& axis, const Extent& across, const Extent& z, std::int32_t size_px) {
    const auto project_end = [&](std::int64_t end_16, bool outward) {
        return axis.centre.raw + project_axis_8(axis, end_16, outward ? z.least_16 : z.greatest_16);
    };
    const std::int64_t least_8 = project_end(across.least_16, across.least_16 < 0);
    const std::int64_t greatest_8 = project_end(across.greatest_16, across.greatest_16 > 0);
    const auto within = [&](std::int64_t pixel) {
        return static_cast<std::int32_t>(std::clamp<std::int64_t>(pixel, 0, size_px));
    };
    return {within(floor_shift(least_8, 8) - 1), within(floor_shift(greatest_8, 8) + 2)};
}

}  // namespace

std::optional<ScreenRectangle> rectangle_of(const LevelBox& box, const ViewContext& view) {
    constexpr std::int64_t kNearest_16 = std::int64_t{4} << 16;
    const auto middle = [](std::int32_t low, std::int32_t high) { return World::from_raw((low + high) * 2048); };
    // A unit more, for boxes that the file rounds.
    const auto half = [](std::int32_t low, std::int32_t high) { return World::from_raw((high - low) * 2048 + 4096); };
    const Vec3<World> sizes{half(box.mins[0], box.maxs[0]), half(box.mins[1], box.maxs[1]),
                            half(box.mins[2], box.maxs[2])};
    const Vec3<View> centre =
        to_view({middle(box.mins[0], box.maxs[0]), middle(box.mins[1], box.maxs[1]), middle(box.mins[2], box.maxs[2])},
                view.eye, view.axes);

    const Extent z = extent_along(view.axes.forward, centre.z.raw, sizes);
    if (z.least_16 < kNearest_16) return std::nullopt;
    const Extent x = extent_along(view.axes.right, centre.x.raw, sizes);
    const Extent y = extent_along(view.axes.up, -centre.y.raw, sizes);
    const PixelRange columns = project_extent(view.projection.x, x, z, view.projection.width_px);
    const PixelRange rows = project_extent(view.projection.y, y, z, view.projection.height_px);
    return ScreenRectangle{columns.first, columns.end, rows.first, rows.end};
}

}  // namespace oblong

#include "engine/view/outline.h"

#include "engine/view/project.h"

namespace oblong {

namespace {

/// The least and the greatest of a box's corners along a direction of the screen, in whole pixels.
struct Bounds {
    std::int64_t least = ScreenOutline::kUnlimited, greatest = -ScreenOutline::kUnlimited;

    void add(ScreenWide position) {
        least = std::min(least, floor_of(position));
        greatest = std::max(greatest, floor_of(position));
    }
    PixelRange range(std::int64_t margin, std::int64_t first, std::int64_t end) const {
        const auto within = [=](std::int64_t pixel) {
            return static_cast<std::int32_t>(std::clamp<std::int64_t>(pixel, first, end));
        };
        return {within(least - margin), within(greatest + margin + 1)};
    }
};

}  // namespace

ScreenOutline outline_of(const ViewBox& box, const Projection& projection) {
    const std::int32_t width_px = projection.width_px, height_px = projection.height_px;
    if (box.nearest_z() < kExactFrom) return {{0, width_px, 0, height_px}};
    Bounds columns, rows, sums, differences;
    for (unsigned corner = 0; corner < 8; ++corner) {
        Vec3<View> place = box.middle;
        for (std::size_t i = 0; i < 3; ++i) place = (corner >> i & 1) != 0 ? place + box.arms[i] : place - box.arms[i];
        const auto [x, y] = project(place, projection);
        columns.add(x);
        rows.add(y);
        sums.add(x + y);
        differences.add(x - y);
    }
    // Rounding moves a column and a row by a pixel each; of a sum or difference, their floors leave another.
    constexpr std::int32_t kMost = ScreenOutline::kUnlimited;
    const PixelRange across = columns.range(1, 0, width_px), down = rows.range(1, 0, height_px);
    return {{across.first, across.end, down.first, down.end},
            sums.range(3, -kMost, kMost),
            differences.range(3, -kMost, kMost)};
}

}  // namespace oblong

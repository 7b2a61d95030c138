#include "engine/view/clip_line.h"

#include <algorithm>

#include "engine/view/clip.h"
#include "engine/view/project.h"

namespace oblong {

namespace {

constexpr ClipDistance kOnVolumePlane{};

/// part / whole of a line's length; whole > 0.
struct LinePart {
    ClipDistance part, whole;

    bool operator<(const LinePart& other) const {
        return compare_products(part.bits(), other.whole.bits(), other.part.bits(), whole.bits()) < 0;
    }
};

Vec3<View> place_along(const ViewLine& line, const LinePart& t) {
    return between(line.from, line.to, t.part, t.whole);
}

}  // namespace

ClipDistance half_distance(const ClipPlane& plane, const Vec3<View>& p) {
    return floor_shift(plane.distance(p), 1);
}

ViewVolume make_view_volume(const Frustum& frustum, View front, View back) {
    constexpr auto kOne = ClipNormal::from_int(1);
    const Vec3<ClipNormal> ahead{{}, {}, kOne};
    ViewVolume volume;
    std::copy(frustum.clip_planes.begin(), frustum.clip_planes.end(), volume.planes.begin());
    volume.planes[4] = {ahead, bounded_product(front, kOne)};
    volume.planes[5] = {-ahead, -bounded_product(back, kOne)};
    return volume;
}

/// With the ends at distances d0 and d1 from a plane, the line crosses it at t = d0 / (d0 - d1).
std::optional<ViewLine> clip_line(const ViewVolume& volume, const ViewLine& line) {
    constexpr ClipDistance kWhole = ClipDistance::ulp();
    LinePart enters{{}, kWhole}, leaves{kWhole, kWhole};
    for (const ClipPlane& plane : volume.planes) {
        const ClipDistance d0 = half_distance(plane, line.from), d1 = half_distance(plane, line.to);
        if (d0 < kOnVolumePlane && d1 < kOnVolumePlane) return {};
        if (d0 < kOnVolumePlane) enters = std::max(enters, LinePart{-d0, d1 - d0});
        if (d1 < kOnVolumePlane) leaves = std::min(leaves, LinePart{d0, d0 - d1});
    }
    if (leaves < enters) return {};
    return ViewLine{place_along(line, enters), place_along(line, leaves)};
}

std::optional<PixelLine> project_line(const ViewVolume& volume, const Projection& projection, const ViewLine& line) {
    const auto clipped = clip_line(volume, line);
    if (!clipped) return {};
    const auto pixel = [&](const Vec3<View>& place) {
        const ScreenPosition position = project(place, projection);
        const auto within = [](ScreenWide at, std::int32_t size_px) {
            return static_cast<std::int32_t>(std::clamp<std::int64_t>(floor_of(at), 0, size_px - 1));
        };
        return PixelPosition{within(position.x, projection.width_px), within(position.y, projection.height_px)};
    };
    return PixelLine{pixel(clipped->from), pixel(clipped->to)};
}

}  // namespace oblong

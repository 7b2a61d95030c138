#include "engine/view/clip_line.h"

#include <algorithm>
#include <bit>

#include "engine/base/table.h"
#include "engine/view/clip.h"
#include "engine/view/project.h"

namespace oblong {

namespace {

constexpr ClipDistance kOnVolumePlane{};

/// Half a distance, so that differences fit; outside stays outside.
ClipDistance half_distance(const ClipPlane& plane, const Vec3<View>& p) {
    return floor_shift(plane.distance(p), 1);
}

/// Cuts an outside end off at one plane after the other. A cut end counts as inside of its plane, wherever rounding put
/// it: so each plane cuts it once at most.
std::optional<ViewLine> clip_by_outcodes(const ViewVolume& volume, ViewLine line) {
    std::array<Vec3<View>*, 2> ends{&line.from, &line.to};
    std::array<unsigned, 2> outside{outcode_of(volume, line.from), outcode_of(volume, line.to)}, undecided{63, 63};
    while ((outside[0] | outside[1]) != 0) {
        if ((outside[0] & outside[1]) != 0) return {};
        const int end = outside[0] != 0 ? 0 : 1;
        const int plane = std::countr_zero(at(outside, end));
        Vec3<View>&cut = *at(ends, end), &other = *at(ends, 1 - end);
        const ClipPlane& side = at(volume.planes, plane);
        const ClipDistance inside = std::max(half_distance(side, other), kOnVolumePlane);
        cut = cross_plane(other, inside, cut, std::min(half_distance(side, cut), kOnVolumePlane - ClipDistance::ulp()));
        at(undecided, end) &= ~(1u << plane);
        at(outside, end) = outcode_of(volume, cut) & at(undecided, end);
    }
    return line;
}

/// A part of a line's length: `part` / `whole`, the latter above 0.
struct LinePart {
    ClipDistance part, whole;

    bool operator<(const LinePart& other) const {
        const auto bits = [](ClipDistance distance) { return static_cast<std::uint64_t>(distance.raw); };
        return compare_products(bits(part), bits(other.whole), bits(other.part), bits(whole)) < 0;
    }
};

Vec3<View> place_along(const ViewLine& line, const LinePart& t) {
    return between(line.from, line.to, t.part, t.whole);
}

/// With d0 and d1 its ends' distances from a plane, the line crosses it at t = d0 / (d0 - d1).
std::optional<ViewLine> clip_by_parts(const ViewVolume& volume, const ViewLine& line) {
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

}  // namespace

ViewVolume make_view_volume(const Frustum& frustum, View front, View back) {
    constexpr auto kOne = ClipNormal::from_int(1);
    const Vec3<ClipNormal> ahead{{}, {}, kOne};
    ViewVolume volume;
    std::copy(frustum.clip_planes.begin(), frustum.clip_planes.end(), volume.planes.begin());
    volume.planes[4] = {ahead, bounded_product(front, kOne)};
    volume.planes[5] = {-ahead, -bounded_product(back, kOne)};
    return volume;
}

unsigned outcode_of(const ViewVolume& volume, const Vec3<View>& p) {
    unsigned outcode = 0;
    for (unsigned plane = 0; plane < volume.planes.size(); ++plane)
        outcode |= static_cast<unsigned>(volume.planes[plane].distance(p) < kOnVolumePlane) << plane;
    return outcode;
}

std::optional<ViewLine> clip_line(const ViewVolume& volume, const ViewLine& line, LineClipping method) {
    return method == LineClipping::CohenSutherland ? clip_by_outcodes(volume, line) : clip_by_parts(volume, line);
}

std::optional<PixelLine> project_line(const ViewVolume& volume, const Projection& projection, const ViewLine& line) {
    const auto clipped = clip_line(volume, line, LineClipping::LiangBarsky);
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

#include "engine/methods/lines.h"

#include <algorithm>
#include <bit>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/view/clip.h"

namespace oblong {

std::optional<LineHit> intersect_line(const Vec3<World>& world_start, const Vec3<World>& world_end,
                                      const Plane& plane) {
    const PlaneDistance from_start = distance_to_plane(world_start, plane);
    if (from_start == PlaneDistance{}) return LineHit{world_start, {}};
    const PlaneDistance approach = from_start - distance_to_plane(world_end, plane);
    if (approach == PlaneDistance{}) return std::nullopt;
    return LineHit{between(world_start, world_end, from_start, approach),
                   divide<Fixed<std::int64_t, 32>>(from_start, approach)};
}

std::optional<LineHit> intersect_segment(const Vec3<World>& world_start, const Vec3<World>& world_end,
                                         const Plane& plane) {
    const PlaneDistance none{};
    const PlaneDistance from_start = distance_to_plane(world_start, plane);
    const PlaneDistance from_end = distance_to_plane(world_end, plane);
    if (from_start > none && from_end > none) return std::nullopt;
    if (from_start < none && from_end < none) return std::nullopt;
    return intersect_line(world_start, world_end, plane);
}

namespace {

constexpr ClipDistance kOnVolumePlane{};

/// Cuts an outside end at one plane after the other. A cut end counts as inside of its plane, whatever its rounding, so
/// that each plane cuts it at most once.
std::optional<ViewLine> clip_by_outcodes(const ViewVolume& volume, ViewLine line) {
    std::array<Vec3<View>*, 2> ends{&line.from, &line.to};
    std::array<unsigned, 2> outside{outcode_of(volume, line.from), outcode_of(volume, line.to)}, undecided{63, 63};
    while ((outside[0] | outside[1]) != 0) {
        if ((outside[0] & outside[1]) != 0) return {};
        const int end = outside[0] != 0 ? 0 : 1;
        const int plane = std::countr_zero(item(outside, end));
        Vec3<View>&cut = *item(ends, end), &other = *item(ends, 1 - end);
        const ClipPlane& side = item(volume.planes, plane);
        const ClipDistance inside = std::max(half_distance(side, other), kOnVolumePlane);
        cut = cross_plane(other, inside, cut, std::min(half_distance(side, cut), kOnVolumePlane - ClipDistance::ulp()));
        item(undecided, end) &= ~(1u << plane);
        item(outside, end) = outcode_of(volume, cut) & item(undecided, end);
    }
    return line;
}

}  // namespace

unsigned outcode_of(const ViewVolume& volume, const Vec3<View>& p) {
    unsigned outcode = 0;
    for (unsigned plane = 0; plane < volume.planes.size(); ++plane)
        outcode |= static_cast<unsigned>(volume.planes[plane].distance(p) < kOnVolumePlane) << plane;
    return outcode;
}

std::optional<ViewLine> clip_line(const ViewVolume& volume, const ViewLine& line, LineClipping method) {
    return method == LineClipping::CohenSutherland ? clip_by_outcodes(volume, line) : clip_line(volume, line);
}

}  // namespace oblong

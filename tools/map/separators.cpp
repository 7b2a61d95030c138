#include "tools/map/separators.h"

namespace oblong::map {
namespace {

// All on one side, and some truly so.
bool is_behind(const Winding& winding, const Plane& plane) {
    const Reach far = reach(winding, plane);
    return far.front <= kOnEpsilon && far.back > kOnEpsilon;
}

// Cuts `target` by the planes through an edge of `a` and a corner of `b` that separate them; keeps b's side if
// `keeps_far`, else a's.
Winding cut_by_separators(const Winding& a, const Winding& b, Winding target, bool keeps_far) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Point edge = a[(i + 1) % a.size()] - a[i];
        for (const Point& corner : b) {
            const Point across = cross(edge, corner - a[i]);
            const double size = length(across);
            if (size < kOnEpsilon) continue;
            const Point normal = scaled(across, 1 / size);
            Plane plane{normal, dot(normal, a[i])};
            if (!is_behind(a, plane)) plane = plane.flipped();
            if (!is_behind(a, plane) || !is_behind(b, plane.flipped())) continue;
            SplitWinding parts = split(target, keeps_far ? plane : plane.flipped());
            target = std::move(parts.front);
            if (target.empty()) return target;
        }
    }
    return target;
}

}  // namespace

Winding seen_through(const Winding& source, const Winding& pass, Winding target) {
    target = cut_by_separators(source, pass, std::move(target), true);
    if (target.empty()) return target;
    return cut_by_separators(pass, source, std::move(target), false);
}

}  // namespace oblong::map

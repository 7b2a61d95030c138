#include "tools/map/source/geometry.h"

#include <algorithm>

namespace oblong::map {
namespace {

// Ties (a normal at 45 degrees) go to the first axis, whatever the rounding of the last bits.
int longest_axis(const Point& normal) {
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis) {
        if (std::abs(component(normal, axis)) > std::abs(component(normal, longest)) + PlaneList::kNormalEpsilon)
            longest = axis;
    }
    return longest;
}

Plane snapped(Plane plane) {
    const int axis = longest_axis(plane.normal);
    if (component(plane.normal, axis) < 1 - PlaneList::kNormalEpsilon * PlaneList::kNormalEpsilon) return plane;
    plane.normal = axis_vector(axis);
    const double whole = std::round(plane.distance);
    if (std::abs(plane.distance - whole) < PlaneList::kDistanceEpsilon) plane.distance = whole;
    return plane;
}

long bucket_of(double distance) {
    return std::lround(distance);
}

bool is_same(const Plane& a, const Plane& b) {
    const Point apart = a.normal - b.normal;
    return std::abs(a.distance - b.distance) < PlaneList::kDistanceEpsilon &&
           std::max({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)}) < PlaneList::kNormalEpsilon;
}

}  // namespace

int plane_type(const Plane& plane) {
    const int axis = longest_axis(plane.normal);
    return component(plane.normal, axis) == 1.0 ? axis : axis + 3;
}

PlaneSide PlaneList::find_or_add(const Plane& plane) {
    const bool is_back = component(plane.normal, longest_axis(plane.normal)) < 0;
    const Plane wanted = snapped(is_back ? plane.flipped() : plane);
    const int known = find(wanted);
    if (known >= 0) return {known, is_back};
    planes_.push_back(wanted);
    by_distance_[bucket_of(wanted.distance)].push_back(count() - 1);
    return {count() - 1, is_back};
}

int PlaneList::find(const Plane& plane) const {
    const long middle = bucket_of(plane.distance);
    for (long bucket = middle - 1; bucket <= middle + 1; ++bucket) {
        const auto found = by_distance_.find(bucket);
        if (found == by_distance_.end()) continue;
        for (const int index : found->second) {
            if (is_same((*this)[index], plane)) return index;
        }
    }
    return -1;
}

}  // namespace oblong::map

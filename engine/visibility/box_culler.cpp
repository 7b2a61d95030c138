#include "engine/visibility/box_culler.h"

namespace oblong {

BoxCuller::BoxCuller(const Frustum& frustum, const Vec3<World>& eye) {
    for (std::size_t side = 0; side < sides_.size(); ++side) {
        const CullPlane& plane = frustum.cull_planes[side];
        const Vec3<Distance>& n = plane.normal;
        const CullDistance of_eye = dot(n, eye);
        const auto limit = [of_eye](CullDistance distance) {
            return -convert<Distance>(-(distance + of_eye) * 2, Rounding::Floor);
        };
        sides_[side] = {n, {absolute(n.x), absolute(n.y), absolute(n.z)}, limit(plane.outside), limit(plane.inside)};
    }
}

}  // namespace oblong

#include "engine/visibility/front_to_back.h"

#include "engine/base/range_probe.h"

namespace oblong {

std::uint8_t planes_crossed(const Frustum& frustum, const LevelBox& box, const Vec3<World>& eye, std::uint8_t planes) {
    if (planes == 0) return 0;
    const std::array<std::int64_t, 3> at{eye.x.raw, eye.y.raw, eye.z.raw};
    // Normals of .20 may be off by 2^-21 in each component: a box is given the benefit of that, and of a unit more.
    constexpr std::int64_t kBenefit_32 = std::int64_t{1} << 32;
    for (unsigned plane = 0; plane < 4; ++plane) {
        if (!(planes >> plane & 1)) continue;
        const auto& normal = frustum.cull_planes[plane].normal;
        std::int64_t farthest_32 = kBenefit_32, nearest_32 = -kBenefit_32;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t low = normal[axis] * (std::int64_t{box.mins[axis]} * 4096 - at[axis]);
            const std::int64_t high = normal[axis] * (std::int64_t{box.maxs[axis]} * 4096 - at[axis]);
            farthest_32 += low > high ? low : high;
            nearest_32 += low > high ? high : low;
        }
        note_range<Quantity::CullDistance>(farthest_32);
        note_range<Quantity::CullDistance>(nearest_32);
        if (farthest_32 < 0) return kOutside;
        if (nearest_32 >= 0) planes = static_cast<std::uint8_t>(planes & ~(1u << plane));
    }
    return planes;
}

}  // namespace oblong

#pragma once

#include <array>
#include <cstdint>

#include "engine/base/range_probe.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/projection.h"
#include "engine/math/basis.h"

namespace oblong {

/// Which sides of the view a point is outside of, a bit each. There is no near plane: the sides meet in the eye, and
/// all that is inside of them is before it. What a near plane cuts off a wall that the eye touches is a hole (hard case
/// V12). Behind the eye is no side of its own, as such a point is outside of another; it tells what wholly lies there.
enum Outcode : std::uint8_t { kOutLeft = 1, kOutRight = 2, kOutBottom = 4, kOutTop = 8, kOutBehind = 16 };
inline constexpr int kClipPlaneCount = 4;

/// normal . p - offset >= 0 is inside; p in viewspace, 48.16. Normals below 2^25, so that 35-bit positions give
/// distances below 2^62.
struct ClipPlane {
    std::array<std::int64_t, 3> normal{};
    std::int64_t offset = 0;

    std::int64_t distance(const Vec3<View>& p) const {
        const std::int64_t along = normal[0] * p.x.raw + normal[1] * p.y.raw + normal[2] * p.z.raw - offset;
        note_range<Quantity::ClipDistance>(along);
        return along;
    }
};

/// A side plane in the world, through the eye: normal . (p - eye) >= 0 is inside; for culling boxes. Normal .20.
struct CullPlane {
    std::array<std::int64_t, 3> normal{};
};

struct Frustum {
    std::array<ClipPlane, kClipPlaneCount> clip_planes;  ///< in the order of Outcode's bits
    std::array<CullPlane, 4> cull_planes;                ///< left, right, bottom, top
};

/// The planes of what the screen shows. A point on a plane is inside.
Frustum make_frustum(const Basis& axes, const Projection& projection);

/// The outcode of a point in viewspace.
inline std::uint8_t outcode_of(const Frustum& frustum, const Vec3<View>& p) {
    const std::int64_t x = frustum.clip_planes[0].normal[0] * p.x.raw,
                       x_limit = frustum.clip_planes[0].normal[2] * p.z.raw;
    const std::int64_t y = frustum.clip_planes[2].normal[1] * p.y.raw,
                       y_limit = frustum.clip_planes[2].normal[2] * p.z.raw;
    return static_cast<std::uint8_t>((x_limit + x < 0) * kOutLeft | (x_limit - x < 0) * kOutRight |
                                     (y_limit + y < 0) * kOutBottom | (y_limit - y < 0) * kOutTop |
                                     (p.z.raw < 0) * kOutBehind);
}

}  // namespace oblong

#pragma once

#include <array>
#include <cstdint>

#include "engine/base/range_probe.h"
#include "engine/camera/camera.h"
#include "engine/math/basis.h"
#include "engine/screen/projection.h"

namespace oblong {

/// The nearest depth that is drawn: 4 steps of View, 2^-14 unit. The side planes pass through the eye, so that what is
/// clipped to them never projects off the screen however near it comes; this plane only keeps z above zero. A plane
/// nearer than a unit's 64th is where valid views would show holes (hard case V12).
inline constexpr std::int64_t kNearZ_16 = 4;

/// Which sides of the view a point is outside of, a bit each.
enum Outcode : std::uint8_t { kOutLeft = 1, kOutRight = 2, kOutBottom = 4, kOutTop = 8, kOutNear = 16 };
inline constexpr int kClipPlaneCount = 5;

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
Frustum make_frustum(const Basis& axes, const Projection& lens);

/// The outcode of a point in viewspace.
inline std::uint8_t outcode_of(const Frustum& frustum, const Vec3<View>& p) {
    const std::int64_t x = frustum.clip_planes[0].normal[0] * p.x.raw,
                       x_limit = frustum.clip_planes[0].normal[2] * p.z.raw;
    const std::int64_t y = frustum.clip_planes[2].normal[1] * p.y.raw,
                       y_limit = frustum.clip_planes[2].normal[2] * p.z.raw;
    return static_cast<std::uint8_t>((x_limit + x < 0) * kOutLeft | (x_limit - x < 0) * kOutRight |
                                     (y_limit + y < 0) * kOutBottom | (y_limit - y < 0) * kOutTop |
                                     (p.z.raw < kNearZ_16) * kOutNear);
}

}  // namespace oblong

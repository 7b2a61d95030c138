#pragma once

#include <array>
#include <cstdint>

#include "engine/base/range_probe.h"
#include "engine/math/basis.h"
#include "engine/view/projection.h"

namespace oblong {

/// Which sides of the view a point is outside of, a bit each (Cohen and Sutherland). There is no near plane: the side
/// planes meet in the eye, and everything inside them is in front of it. A near plane would cut a hole into a wall that
/// the eye touches (hard case V12). kOutBehind is no clip plane; it serves to reject polygons wholly behind the eye.
enum Outcode : std::uint8_t { kOutLeft = 1, kOutRight = 2, kOutBottom = 4, kOutTop = 8, kOutBehind = 16 };
inline constexpr int kClipPlaneCount = 4;

/// A component of a clip plane's normal, which need not be of length 1: from -1 to 1, so that 35-bit positions give
/// 62-bit distances.
using ClipNormal = Fixed<std::int64_t, 25>;
using ClipDistance = Fixed<std::int64_t, 41>;

/// normal . p - offset >= 0 is inside; p in viewspace.
struct ClipPlane {
    Vec3<ClipNormal> normal;
    ClipDistance offset;

    ClipDistance distance(const Vec3<View>& p) const {
        const ClipDistance along = dot(normal, p) - offset;
        note_range<"clip distance">(along);
        return along;
    }
};

/// A distance from a cull plane, times the length of its normal.
using CullDistance = Fixed<std::int64_t, 32>;

/// A side plane in the world, for culling boxes: normal . (p - eye) is below `outside` for points that are surely
/// outside, and at least `inside` for those that are surely inside. Conservative by one unit, and so by the error of
/// the normal: up to 2^-21 in each component. In a perspective view the plane goes through the eye.
struct CullPlane {
    using Component = Fixed<std::int64_t, 20>;
    Vec3<Component> normal;
    CullDistance outside, inside;
};

struct Frustum {
    std::array<ClipPlane, kClipPlaneCount> clip_planes;  ///< in the order of Outcode's bits
    std::array<CullPlane, 4> cull_planes;                ///< left, right, bottom, top
};

/// The planes of the view frustum; with a `parallel_depth` above 0 (ViewContext) that is a box. A point on a plane is
/// inside.
Frustum make_frustum(const Basis& axes, const Projection& projection, View parallel_depth = {});

/// Moves the cull planes to the borders of a part of the screen, a pixel outward; the clip planes stay. For views of
/// which no more than that is drawn.
void narrow_cull_planes(const Basis& axes, const Projection& projection, View parallel_depth,
                        const ScreenRectangle& part, Frustum& frustum);

/// The outcode of a point in viewspace.
inline std::uint8_t outcode_of(const Frustum& frustum, const Vec3<View>& p) {
    constexpr ClipDistance kOn{};
    const Vec3<ClipNormal>&left = frustum.clip_planes[0].normal, &bottom = frustum.clip_planes[2].normal;
    const ClipDistance x = bounded_product(left.x, p.x), x_limit = bounded_product(left.z, p.z);
    const ClipDistance y = bounded_product(bottom.y, p.y), y_limit = bounded_product(bottom.z, p.z);
    return static_cast<std::uint8_t>((x_limit + x < kOn) * kOutLeft | (x_limit - x < kOn) * kOutRight |
                                     (y_limit + y < kOn) * kOutBottom | (y_limit - y < kOn) * kOutTop |
                                     (p.z < View{}) * kOutBehind);
}

}  // namespace oblong

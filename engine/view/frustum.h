#pragma once

#include <array>
#include <cstdint>

#include "engine/base/range_probe.h"
#include "engine/math/basis.h"
#include "engine/view/projection.h"

namespace oblong {

/// The sides of the view that a point is outside of, one bit each (Cohen and Sutherland). There is no near plane: the
/// side planes meet in the eye, and everything inside them is in front of it. A near plane would cut a hole into a wall
/// that the eye touches (hard case V12). kOutBehind is not a clip plane; it rejects polygons wholly behind the eye.
enum Outcode : std::uint8_t { kOutLeft = 1, kOutRight = 2, kOutBottom = 4, kOutTop = 8, kOutBehind = 16 };
inline constexpr int kClipPlaneCount = 4;

/// A component of a clip plane's normal, from -1 to 1, so that 35-bit positions give 62-bit distances. The normal's
/// length is not 1.
using ClipNormal = Fixed<std::int32_t, 25>;
using ClipDistance = Fixed<std::int64_t, 41>;

/// Inside: normal . p - offset >= 0, p in viewspace.
struct ClipPlane {
    Vec3<ClipNormal> normal;
    ClipDistance offset;

    ClipDistance distance(const Vec3<View>& p) const {
        const ClipDistance along = dot(normal, p) - offset;
        note_range<"clip distance">(along);
        return along;
    }
};

/// A distance from a cull plane times the length of its normal.
using CullDistance = Fixed<std::int64_t, 32>;

/// A side plane in the world, for culling boxes. If normal . (p - eye) is below `outside`, p is certainly outside; if
/// it is at least `inside`, certainly inside. The margin of one unit covers the error of the normal, up to 2^-21 in
/// each component. In a perspective view the plane goes through the eye.
struct CullPlane {
    using Component = Fixed<std::int64_t, 20>;
    Vec3<Component> normal;
    CullDistance outside, inside;
};

struct Frustum {
    std::array<ClipPlane, kClipPlaneCount> clip_planes;  ///< in the order of Outcode's bits
    std::array<CullPlane, 4> cull_planes;                ///< left, right, bottom, top
};

/// The planes of the view frustum, which is a box if parallel_depth > 0 (ViewContext). A point on a plane is inside.
Frustum make_frustum(const Basis& axes, const Projection& projection, View parallel_depth = {});

/// Moves the cull planes of a perspective view to the borders of a part of the screen, one pixel outward, for views of
/// which only this part is drawn. The clip planes stay.
void narrow_cull_planes(const Basis& axes, const Projection& projection, const ScreenRectangle& part, Frustum& frustum);

/// The outcode of a point in viewspace, a View or one of 32 bits.
template <class Position>
[[gnu::always_inline]] inline std::uint8_t outcode_of(const Frustum& frustum, const Vec3<Position>& p) {
    constexpr ClipDistance kOn{};
    const Vec3<ClipNormal>&left = frustum.clip_planes[0].normal, &bottom = frustum.clip_planes[2].normal;
    const ClipDistance x = bounded_product(left.x, p.x), x_limit = bounded_product(left.z, p.z);
    const ClipDistance y = bounded_product(bottom.y, p.y), y_limit = bounded_product(bottom.z, p.z);
    return static_cast<std::uint8_t>((x_limit + x < kOn) * kOutLeft | (x_limit - x < kOn) * kOutRight |
                                     (y_limit + y < kOn) * kOutBottom | (y_limit - y < kOn) * kOutTop |
                                     (p.z < Position{}) * kOutBehind);
}

}  // namespace oblong

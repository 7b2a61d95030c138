#include "engine/geometry/frustum.h"

namespace oblong {

namespace {

/// The slopes of a pair of side planes: across * |x| <= along * z, both below 2^25.
struct SideSlope {
    std::int64_t across, along;
};

SideSlope make_slope(Multiplier multiplier, std::int32_t size_px) {
    std::int64_t across = multiplier.raw, along = std::int64_t{size_px} << 31;
    int shift = 0;
    while (((across | along) >> shift) >= (std::int64_t{1} << 25)) ++shift;
    return {rounded_shift(across, shift, Rounding::NearestHalfUp),
            rounded_shift(along, shift, Rounding::NearestHalfUp)};
}

std::int64_t to_20(Unit component) {
    return rounded_shift(std::int64_t{component.raw}, 10, Rounding::NearestHalfUp);
}

/// The world-space twin of a view-space side plane: its normal is a mix of two of the camera's axes.
CullPlane make_cull_plane(const Vec3<Unit>& across_axis, std::int64_t across, const Vec3<Unit>& forward,
                          std::int64_t along) {
    const auto mix = [&](Unit a, Unit f) {
        const std::int64_t mixed_45 = to_20(a) * across + to_20(f) * along;
        note_range<Quantity::CullMix>(mixed_45);
        return rounded_shift(mixed_45, 25, Rounding::NearestHalfUp);
    };
    return {{mix(across_axis.x, forward.x), mix(across_axis.y, forward.y), mix(across_axis.z, forward.z)}};
}

}  // namespace

Frustum make_frustum(const Basis& axes, const Projection& projection) {
    const SideSlope x = make_slope(projection.x.multiplier, projection.width_px);
    const SideSlope y = make_slope(projection.y.multiplier, projection.height_px);

    Frustum frustum;
    frustum.clip_planes[0] = {{x.across, 0, x.along}, 0};
    frustum.clip_planes[1] = {{-x.across, 0, x.along}, 0};
    frustum.clip_planes[2] = {{0, y.across, y.along}, 0};
    frustum.clip_planes[3] = {{0, -y.across, y.along}, 0};
    frustum.cull_planes[0] = make_cull_plane(axes.right, x.across, axes.forward, x.along);
    frustum.cull_planes[1] = make_cull_plane(axes.right, -x.across, axes.forward, x.along);
    frustum.cull_planes[2] = make_cull_plane(axes.up, y.across, axes.forward, y.along);
    frustum.cull_planes[3] = make_cull_plane(axes.up, -y.across, axes.forward, y.along);
    return frustum;
}

}  // namespace oblong

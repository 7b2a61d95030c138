#include "engine/view/frustum.h"

namespace oblong {

namespace {

/// The slopes of a pair of side planes: across * |x| <= along * z. Both are below 1, the larger is above 1/2.
struct SideSlope {
    ClipNormal across, along;
};

/// For a side `distance_1` half pixels from the optical centre; negative if the centre is outside.
SideSlope make_slope(Multiplier multiplier, std::int32_t distance_1) {
    const std::int64_t across = multiplier.raw, along = std::int64_t{distance_1} * (std::int64_t{1} << 31);
    int shift = 0;
    while (((across | (along < 0 ? -along : along)) >> shift) >= (std::int64_t{1} << ClipNormal::kFractionBits))
        ++shift;
    const auto normal = [shift](std::int64_t of) {
        return ClipNormal::from_raw(static_cast<std::int32_t>(rounded_shift(of, shift, Rounding::NearestHalfUp)));
    };
    return {normal(across), normal(along)};
}

/// A side plane in the world: its normal is a linear combination of two of the camera's axes.
CullPlane make_cull_plane(const Vec3<Unit>& across_axis, ClipNormal across, const Vec3<Unit>& forward, ClipNormal along,
                          View parallel_depth) {
    using Component = CullPlane::Component;
    const auto mix = [&](Unit a, Unit f) {
        const auto mixed =
            bounded_product(convert<Component>(a), across) + bounded_product(convert<Component>(f), along);
        note_range<"cull plane's normal">(mixed);
        return convert<Component>(mixed);
    };
    constexpr CullDistance kMargin = CullDistance::from_int(1);
    const auto offset = convert<CullDistance>(bounded_product(along, parallel_depth));
    return {{mix(across_axis.x, forward.x), mix(across_axis.y, forward.y), mix(across_axis.z, forward.z)},
            -offset - kMargin,
            kMargin - offset};
}

/// From the slopes of the four sides.
std::array<CullPlane, 4> make_cull_planes(const Basis& axes, const SideSlope& left, const SideSlope& right,
                                          const SideSlope& bottom, const SideSlope& top, View parallel_depth) {
    return {make_cull_plane(axes.right, left.across, axes.forward, left.along, parallel_depth),
            make_cull_plane(axes.right, -right.across, axes.forward, right.along, parallel_depth),
            make_cull_plane(axes.up, bottom.across, axes.forward, bottom.along, parallel_depth),
            make_cull_plane(axes.up, -top.across, axes.forward, top.along, parallel_depth)};
}

}  // namespace

Frustum make_frustum(const Basis& axes, const Projection& projection, View parallel_depth) {
    const SideSlope x = make_slope(projection.x.multiplier, projection.width_px);
    const SideSlope y = make_slope(projection.y.multiplier, projection.height_px);

    Frustum frustum;
    frustum.clip_planes[0] = {{x.across, {}, x.along}, {}};
    frustum.clip_planes[1] = {{-x.across, {}, x.along}, {}};
    frustum.clip_planes[2] = {{{}, y.across, y.along}, {}};
    frustum.clip_planes[3] = {{{}, -y.across, y.along}, {}};
    frustum.cull_planes = make_cull_planes(axes, x, x, y, y, parallel_depth);
    return frustum;
}

void narrow_cull_planes(const Basis& axes, const Projection& projection, const ScreenRectangle& part,
                        Frustum& frustum) {
    const std::int32_t width_1 = projection.width_px, height_1 = projection.height_px;
    const SideSlope left = make_slope(projection.x.multiplier, width_1 - 2 * (part.first_column - 1));
    const SideSlope right = make_slope(projection.x.multiplier, 2 * (part.end_column + 1) - width_1);
    const SideSlope bottom = make_slope(projection.y.multiplier, 2 * (part.end_row + 1) - height_1);
    const SideSlope top = make_slope(projection.y.multiplier, height_1 - 2 * (part.first_row - 1));
    frustum.cull_planes = make_cull_planes(axes, left, right, bottom, top, {});
}

}  // namespace oblong

#include "engine/scene/face_gradients.h"

#include <algorithm>

#include "engine/base/range_probe.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

/// Texture coordinates of the eye, 16.16, from the world's origin.
std::int64_t eye_texel_16(const Vec3<TexelAxis>& axis, TexelOffset offset, const Vec3<World>& eye) {
    const std::int64_t sum_35 = std::int64_t{axis.x.raw} * eye.x.raw + std::int64_t{axis.y.raw} * eye.y.raw +
                                std::int64_t{axis.z.raw} * eye.z.raw;
    note_range<Quantity::EyeTexelSum>(sum_35);
    const std::int64_t texel_16 = rounded_shift(sum_35, 19, Rounding::NearestHalfUp) + offset.raw;
    note_range<Quantity::EyeTexel>(texel_16);
    return texel_16;
}

}  // namespace

TextureGradients make_face_gradients(const Level& level, const Face& face, const FaceSurface& surface,
                                     const Vec3<World>& offset, const ViewContext& view,
                                     const InverseProjection& inverse_projection) {
    const LevelPlane& plane = level.planes[face.plane];
    const TexInfo& texinfo = level.texinfos[face.texinfo];
    const Vec3<World> eye = view.eye - offset;
    const std::int64_t distance_42 = plane_distance_42(plane, eye);
    TexturedPlane textured;
    textured.normal = face.is_back ? -plane.normal : plane.normal;
    // Edge-on, or turned round by rounding to the screen: a sliver, whose texels any steep view of the plane serves.
    constexpr std::int64_t kLeastDistance_42 = std::int64_t{1} << 30;
    textured.eye_distance =
        PlaneDistance::from_raw(std::max(face.is_back ? -distance_42 : distance_42, kLeastDistance_42));
    textured.s = texinfo.s;
    textured.t = texinfo.t;
    textured.eye_u_16 = eye_texel_16(texinfo.s, texinfo.s_offset, eye) - std::int64_t{surface.origin_u} * 65536;
    textured.eye_v_16 = eye_texel_16(texinfo.t, texinfo.t_offset, eye) - std::int64_t{surface.origin_v} * 65536;
    textured.mip = surface.mip;
    return make_texture_gradients(textured, view.axes, inverse_projection);
}

}  // namespace oblong

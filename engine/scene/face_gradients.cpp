#include "engine/scene/face_gradients.h"

#include <algorithm>

#include "engine/base/range_probe.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

/// Texture coordinates of the eye, from the world's origin.
Texel eye_texel(const Vec3<TexelAxis>& axis, Texel offset, const Vec3<World>& eye) {
    const auto along = dot(axis, eye);
    note_range<"texture axis . eye">(along);
    const Texel texel = convert<Texel>(along) + offset;
    note_range<"texel of the eye">(texel);
    return texel;
}

}  // namespace

TextureGradients make_face_gradients(const Level& level, const Face& face, const FaceSurface& surface,
                                     const Vec3<World>& offset, const ViewContext& view,
                                     const InverseProjection& inverse_projection) {
    const LevelPlane& plane = level.planes[face.plane];
    const TexInfo& texinfo = level.texinfos[face.texinfo];
    const Vec3<World> eye = view.eye - offset;
    const PlaneDistance distance = plane_distance(plane, eye);
    TexturedPlane textured;
    textured.normal = face.is_back ? -plane.normal : plane.normal;
    // Edge-on, or turned round by rounding to the screen: for such a sliver any steep view of the plane will do.
    constexpr auto kLeastDistance = PlaneDistance::from_raw(std::int64_t{1} << 30);
    textured.eye_distance = std::max(face.is_back ? -distance : distance, kLeastDistance);
    textured.s = texinfo.s;
    textured.t = texinfo.t;
    textured.eye_u = eye_texel(texinfo.s, texinfo.s_offset, eye) - Texel::from_int(surface.origin_u);
    textured.eye_v = eye_texel(texinfo.t, texinfo.t_offset, eye) - Texel::from_int(surface.origin_v);
    textured.mip = surface.mip;
    return make_texture_gradients(textured, view.axes, inverse_projection);
}

}  // namespace oblong

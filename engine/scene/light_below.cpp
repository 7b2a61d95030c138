#include "engine/scene/light_below.h"

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/level/line_walk.h"

namespace oblong {

namespace {

constexpr World kLowest = World::from_int(-524'287);

/// Texels from the face's first one; s . p for any p, whose parts may be too large for one exact sum.
Texel texel_on(const Vec3<TexelAxis>& axis, Texel offset, std::int32_t least, const Vec3<World>& p) {
    return product<Texel>(axis.x, p.x) + product<Texel>(axis.y, p.y) + product<Texel>(axis.z, p.z) + offset -
           Texel::from_int(least);
}

/// The light of a face's sample at a place on its plane; none where the face does not reach.
std::optional<std::int32_t> light_8_on(const Level& level, const Face& face, const Vec3<World>& p,
                                       const LightStyles& styles) {
    const TexInfo& texinfo = level.texinfos[face.texinfo];
    if (texinfo.material != Material::Lit) return std::nullopt;
    const std::int64_t u = floor_of(texel_on(texinfo.s, texinfo.s_offset, face.texel_min_u, p)),
                       v = floor_of(texel_on(texinfo.t, texinfo.t_offset, face.texel_min_v, p));
    if (u < 0 || v < 0 || u > face.texel_extent_u || v > face.texel_extent_v) return std::nullopt;
    return light_8_of_sample(level, face, u, v, styles);
}

/// That of the first of a node's faces which reaches there.
std::optional<std::int32_t> light_8_at(const Level& level, NodeIndex node, const Vec3<World>& p,
                                       const LightStyles& styles) {
    for (const FaceIndex face : level.nodes[node].faces)
        if (const auto light_8 = light_8_on(level, level.faces[face], p, styles)) return light_8;
    return std::nullopt;
}

}  // namespace

std::int32_t light_8_of_sample(const Level& level, const Face& face, std::int64_t u, std::int64_t v,
                               const LightStyles& styles) {
    std::int32_t sum_8 = 0;
    if (face.light_offset < 0) return sum_8;
    const std::int64_t columns = face.texel_extent_u / 16 + 1, rows = face.texel_extent_v / 16 + 1;
    std::int64_t sample = face.light_offset + v / 16 * columns + u / 16;
    for (const std::uint8_t style : face.styles) {
        if (style == 255) break;
        sum_8 += at(level.lighting, sample) * styles[style % styles.size()];
        sample += columns * rows;
    }
    return sum_8;
}

std::optional<std::int32_t> light_8_below(const Level& level, const Vec3<World>& from, const LightStyles& styles) {
    if (level.lighting.empty()) return std::nullopt;
    std::optional<std::int32_t> light_8;
    walk_line(level, level.world().root, from, {from.x, from.y, kLowest}, {},
              [&](LeafIndex, std::optional<NodeIndex> entered, const Vec3<World>& place) {
                  if (entered) light_8 = light_8_at(level, *entered, place, styles);
                  return light_8.has_value();
              });
    return light_8;
}

}  // namespace oblong

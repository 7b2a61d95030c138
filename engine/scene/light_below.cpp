#include "engine/scene/light_below.h"

#include <vector>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

constexpr World kLowest = World::from_int(-524'287);

/// A part of the vertical line that is still to be followed down the tree, and the node on whose plane it begins.
struct PendingPart {
    NodeChild at;
    World high, low;
    std::optional<NodeIndex> entered;
};

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

/// That of the first of a node's faces which reaches there.
std::optional<std::int32_t> light_8_at(const Level& level, NodeIndex node, const Vec3<World>& p,
                                       const LightStyles& styles) {
    for (const FaceIndex face : level.nodes[node].faces)
        if (const auto light_8 = light_8_on(level, level.faces[face], p, styles)) return light_8;
    return std::nullopt;
}

}  // namespace

std::optional<std::int32_t> light_8_below(const Level& level, const Vec3<World>& from, const LightStyles& styles) {
    if (level.lighting.empty()) return std::nullopt;
    const auto at_height = [&from](World z) { return Vec3<World>{from.x, from.y, z}; };
    std::vector<PendingPart> parts{{level.world().root, from.z, kLowest, {}}};
    while (!parts.empty()) {
        PendingPart part = parts.back();
        parts.pop_back();
        if (part.entered)
            if (const auto light_8 = light_8_at(level, *part.entered, at_height(part.high), styles)) return light_8;
        while (!part.at.is_leaf()) {
            const NodeIndex index = part.at.node();
            const Node& node = level.nodes[index];
            const PlaneDistance high = plane_distance(level.planes[node.plane], at_height(part.high)),
                                low = plane_distance(level.planes[node.plane], at_height(part.low));
            const bool high_back = high < PlaneDistance{}, low_back = low < PlaneDistance{};
            part.at = node.children[high_back];
            if (high_back == low_back) continue;
            const World middle = between(part.high, part.low, high, high - low);
            parts.push_back({node.children[low_back], middle, part.low, index});
            part.low = middle;
        }
    }
    return std::nullopt;
}

}  // namespace oblong

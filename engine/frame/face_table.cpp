#include "engine/frame/face_table.h"

#include <algorithm>

#include "engine/fixed/root.h"
#include "engine/frame/lit_faces.h"

namespace oblong {

namespace {

FaceKind kind_of(const Level& level, const Face& face) {
    const TexInfo& texinfo = level.texinfos[static_cast<std::size_t>(face.texinfo)];
    const std::string& name = level.textures[static_cast<std::size_t>(texinfo.miptex)].name;
    if (name.starts_with("sky")) return FaceKind::Sky;
    return texinfo.is_special || name.starts_with("*") ? FaceKind::Liquid : FaceKind::Lit;
}

std::int64_t length_16(const Vec3<TexelAxis>& axis) {
    const auto square = [](TexelAxis a) { return static_cast<std::uint64_t>(std::int64_t{a.raw} * a.raw); };
    const std::uint64_t sum_46 = square(axis.x) + square(axis.y) + square(axis.z);
    return static_cast<std::int64_t>(integer_root(sum_46) >> 7);
}

EffectSet effects_of(const Level& level, const Leaf& leaf, const std::vector<FaceKind>& kinds) {
    EffectSet effects;
    for (std::int32_t i = 0; i < leaf.mark_face_count; ++i) {
        const auto face =
            static_cast<std::size_t>(level.mark_faces[static_cast<std::size_t>(leaf.first_mark_face + i)]);
        if (kinds[face] == FaceKind::Sky) effects = effects.with(Effect::Sky);
        if (kinds[face] == FaceKind::Liquid) effects = effects.with(Effect::Liquid);
    }
    return effects;
}

}  // namespace

FaceTable make_face_table(const Level& level) {
    FaceTable table;
    for (const std::int32_t edge : level.surf_edges) {
        const EdgeIndices& indices = level.edges[static_cast<std::size_t>(edge < 0 ? -edge : edge)];
        table.corners.push_back(edge < 0 ? indices.to : indices.from);
    }
    for (const Face& face : level.faces) {
        table.kinds.push_back(kind_of(level, face));
        table.most_corners = std::max(table.most_corners, static_cast<std::size_t>(face.edge_count));
        if (table.kinds.back() != FaceKind::Lit) continue;
        table.most_light_samples = std::max(table.most_light_samples, light_sample_count(face));
        table.largest_surface_bytes = std::max(table.largest_surface_bytes, surface_bytes(face, 0));
    }
    for (const Leaf& leaf : level.leaves) table.leaf_effects.push_back(effects_of(level, leaf, table.kinds));
    for (const TexInfo& texinfo : level.texinfos)
        table.density_16.push_back(std::max(length_16(texinfo.s), length_16(texinfo.t)));
    return table;
}

}  // namespace oblong

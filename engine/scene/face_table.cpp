#include "engine/scene/face_table.h"

#include <algorithm>

#include "engine/level/t_junctions.h"

namespace oblong {

namespace {

FaceKind kind_of(const Level& level, const Face& face) {
    const TexInfo& texinfo = level.texinfos[static_cast<std::size_t>(face.texinfo)];
    const std::string& name = level.textures[static_cast<std::size_t>(texinfo.miptex)].name;
    if (name.starts_with("sky")) return FaceKind::Sky;
    return texinfo.is_special || name.starts_with("*") ? FaceKind::Liquid : FaceKind::Lit;
}

EffectSet effects_of(const Level& level, const Leaf& leaf, const std::vector<FaceKind>& kinds) {
    EffectSet effects;
    for (std::int32_t i = 0; i < leaf.mark_face_count; ++i) {
        const std::int32_t face = level.mark_faces[static_cast<std::size_t>(leaf.first_mark_face + i)];
        effects = effects | effects_of(kinds[static_cast<std::size_t>(face)]);
    }
    return effects;
}

/// The corners of a face, each edge with the vertices inside it, in the direction in which the face walks it.
void append_corners(const Level& level, const Face& face, const TJunctions& junctions,
                    std::vector<std::int32_t>& corners) {
    for (std::int32_t i = face.first_surfedge; i < face.first_surfedge + face.edge_count; ++i) {
        const std::int32_t edge = level.surf_edges[static_cast<std::size_t>(i)];
        const EdgeIndices& ends = level.edges[static_cast<std::size_t>(edge < 0 ? -edge : edge)];
        const std::span<const std::int32_t> inside = junctions.on_edge(edge < 0 ? -edge : edge);
        corners.push_back(edge < 0 ? ends.to : ends.from);
        if (edge < 0)
            corners.insert(corners.end(), inside.rbegin(), inside.rend());
        else
            corners.insert(corners.end(), inside.begin(), inside.end());
    }
}

}  // namespace

FaceTable make_face_table(const Level& level) {
    FaceTable table;
    const TJunctions junctions(level);
    for (const Face& face : level.faces) {
        table.kinds.push_back(kind_of(level, face));
        table.first_corners.push_back(table.corners.size());
        append_corners(level, face, junctions, table.corners);
        table.most_corners = std::max(table.most_corners, table.corners.size() - table.first_corners.back());
    }
    table.first_corners.push_back(table.corners.size());
    for (const Leaf& leaf : level.leaves) table.leaf_effects.push_back(effects_of(level, leaf, table.kinds));
    for (const TexInfo& texinfo : level.texinfos)
        table.density.push_back(convert<TexelDensity>(std::max(length(texinfo.s), length(texinfo.t)), Rounding::Floor));
    return table;
}

}  // namespace oblong

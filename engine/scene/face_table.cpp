#include "engine/scene/face_table.h"

#include <algorithm>

#include "engine/level/t_junctions.h"

namespace oblong {

namespace {

/// Appends the corners of a face, each edge with the vertices inside it, in the face's direction.
void append_corners(const Level& level, const Face& face, const TJunctions& junctions,
                    std::vector<VertexIndex>& corners) {
    for (const SurfEdge step : level.edges_of(face)) {
        const std::span<const VertexIndex> inside = junctions.on_edge(step.edge);
        corners.push_back(level.start_of(step));
        if (step.is_reversed)
            corners.insert(corners.end(), inside.rbegin(), inside.rend());
        else
            corners.insert(corners.end(), inside.begin(), inside.end());
    }
}

void add_face(const Level& level, const Face& face, const TJunctions& junctions, FaceTable& table) {
    const TexInfo& texinfo = level.texinfos[face.texinfo];
    const std::size_t first = table.corners.size();
    append_corners(level, face, junctions, table.corners);
    const std::size_t count = table.corners.size() - first;
    table.faces.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count),
                           convert<TexelDensity>(std::max(length(texinfo.s), length(texinfo.t)), Rounding::Floor),
                           texinfo.material});
    table.most_corners = std::max(table.most_corners, count);
}

}  // namespace

FaceTable make_face_table(const Level& level) {
    FaceTable table;
    const TJunctions junctions(level);
    for (const Face& face : level.faces) add_face(level, face, junctions, table);
    for (const Leaf& leaf : level.leaves) {
        EffectSet effects;
        for (const FaceIndex face : level.faces_at(leaf)) effects = effects | effects_of(table.faces[face].material);
        table.leaf_effects.push_back(effects);
    }
    return table;
}

}  // namespace oblong

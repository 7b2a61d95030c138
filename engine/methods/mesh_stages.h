#pragma once

#include <span>
#include <vector>

#include "engine/mesh/draw_mesh.h"
#include "engine/mesh/mesh_stages.h"

// The stages of a mesh's way to the screen, each for all vertices; draw_mesh() computes only those that it needs.

namespace oblong {

/// Object space to world: positions and normals.
inline void transform_to_world(std::span<const MeshVertex> object_vertices, const MeshTransform& transform,
                               std::vector<WorldVertex>& world_vertices) {
    world_vertices.clear();
    for (const MeshVertex& vertex : object_vertices)
        world_vertices.push_back({world_position(vertex.position, transform), world_normal(vertex.normal, transform)});
}

/// view_vertex() of each vertex.
inline void transform_to_view(std::span<const MeshVertex> object_vertices, const PlacedMesh& placed,
                              const MeshTransform& transform, const ViewContext& view,
                              std::vector<ViewVertex>& view_vertices) {
    const MeshToView to_view = make_mesh_to_view(placed.position, transform, view);
    view_vertices.clear();
    for (const MeshVertex& vertex : object_vertices)
        view_vertex(vertex.position, transform, to_view, view, view_vertices.emplace_back());
}

/// corner_values() of each vertex.
inline void find_corner_values(const PlacedMesh& placed, std::span<const WorldVertex> world_vertices,
                               const MeshLight& light, std::vector<CornerValues>& values) {
    values.clear();
    for (std::size_t i = 0; i < world_vertices.size(); ++i)
        values.push_back(corner_values(placed, i, world_vertices[i], light));
}

}  // namespace oblong

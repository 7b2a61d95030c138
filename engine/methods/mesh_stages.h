#pragma once

#include <span>
#include <vector>

#include "engine/mesh/draw_mesh.h"
#include "engine/mesh/mesh_stages.h"

// The stages of a mesh's way to the screen, each for all vertices; draw_mesh() computes only those that it needs.

namespace oblong {

/// Object space to world: positions and normals.
void transform_to_world(std::span<const MeshVertex> object_vertices, const MeshTransform& transform,
                        std::vector<WorldVertex>& world_vertices);

/// view_vertex() of each vertex.
void transform_to_view(std::span<const MeshVertex> object_vertices, const PlacedMesh& placed,
                       const MeshTransform& transform, const ViewContext& view, std::vector<ViewVertex>& view_vertices);

/// corner_values() of each vertex.
void find_corner_values(const PlacedMesh& placed, std::span<const WorldVertex> world_vertices, const MeshLight& light,
                        std::vector<CornerValues>& values);

}  // namespace oblong

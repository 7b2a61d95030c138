#include "engine/methods/mesh_stages.h"

namespace oblong {

void transform_to_world(std::span<const MeshVertex> object_vertices, const MeshTransform& transform,
                        std::vector<WorldVertex>& world_vertices) {
    world_vertices.clear();
    for (const MeshVertex& vertex : object_vertices)
        world_vertices.push_back({world_position(vertex.position, transform), world_normal(vertex.normal, transform)});
}

void transform_to_view(std::span<const MeshVertex> object_vertices, const PlacedMesh& placed,
                       const MeshTransform& transform, const ViewContext& view,
                       std::vector<ViewVertex>& view_vertices) {
    const MeshToView to_view = make_mesh_to_view(placed.position, transform, view);
    view_vertices.clear();
    for (const MeshVertex& vertex : object_vertices)
        view_vertex(vertex.position, transform, to_view, view, view_vertices.emplace_back());
}

void find_corner_values(const PlacedMesh& placed, std::span<const WorldVertex> world_vertices, const MeshLight& light,
                        std::vector<CornerValues>& values) {
    values.clear();
    for (std::size_t i = 0; i < world_vertices.size(); ++i)
        values.push_back(corner_values(placed, i, world_vertices[i], light));
}

}  // namespace oblong

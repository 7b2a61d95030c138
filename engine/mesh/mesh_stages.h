#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/mesh_light.h"
#include "engine/mesh/placed_mesh.h"
#include "engine/view/clip.h"
#include "engine/view/view_context.h"

// The way of a mesh from its own space to the screen, a function each stage. Each reads what the one before it made,
// and draw_mesh() (engine/mesh/draw_mesh.h) is their order.

namespace oblong {

/// A vertex in the world.
struct WorldVertex {
    Vec3<World> position;
    Vec3<Unit> normal;
};

/// 1/z of a mesh's corners is at most this: those nearer to the eye than 1/128 unit count as that far.
inline constexpr InverseZ kGreatestMeshInverseZ = InverseZ::from_int(128);
/// The largest texel coordinate: beyond it, a skin shows its border.
inline constexpr std::int32_t kMostTexel = 8'191;

/// What goes linearly over the screen, at a corner. With Shading::Phong `light` is the even part of it, else a shade:
/// both with 16 fraction bits, the shade with half a step added, so that its floor is the nearest.
struct CornerValues {
    Texel u, v;
    Fixed<std::int64_t, 16> light;
    Vec3<Unit> normal;  ///< of Shading::Phong
};

/// A vertex as a frame sees it.
struct ViewVertex {
    Vec3<View> position;
    std::uint8_t outcode = 0;
    ScreenVertex screen;  ///< where outcode is 0
    InverseZ inverse_z;   ///< where outcode is 0
};

/// A corner on the screen.
struct ScreenCorner {
    ScreenVertex screen;
    InverseZ inverse_z;
    CornerValues values;
};

/// Object space: the vertices of the frame that is shown, or between two of them (into `scratch`).
std::span<const MeshVertex> pose_of(const PlacedMesh& placed, std::vector<MeshVertex>& scratch);

/// Object space: the numbers of the triangles that face the eye, whose place in object space is handed in. The eye is
/// in front of a triangle if N . (eye - A) > 0, N = (C - A) x (B - A): a dot product, before any vertex is transformed.
/// Those that name vertices that the pose does not have are left out.
void find_facing(std::span<const MeshTriangle> triangles, std::span<const MeshVertex> object_vertices,
                 const Vec3<World>& object_eye, std::vector<std::uint32_t>& facing);

/// The eye in object space; saturates.
Vec3<World> to_object(const Vec3<World>& world_eye, const MeshTransform& transform);

/// A point of object space in the world: by the matrix; saturates.
Vec3<World> world_position(const Vec3<World>& object_position, const MeshTransform& transform);
/// A normal of object space in the world, of length 1: by the inverse transpose, and brought back to that length. Where
/// the mesh is scaled alike along its axes the rotation alone does, within 3 steps (2^-30).
Vec3<Unit> world_normal(const Vec3<Unit>& object_normal, const MeshTransform& transform);
/// Object space to world: both, of all vertices.
void transform_to_world(std::span<const MeshVertex> object_vertices, const MeshTransform& transform,
                        std::vector<WorldVertex>& world_vertices);

/// The normal of a triangle in the world, of length 1: for Shading::Flat.
Vec3<Unit> world_normal(const MeshTriangle& triangle, std::span<const MeshVertex> object_vertices,
                        const MeshTransform& transform);

/// World to view: the position, and the sides of the view that it is outside of; where none, also the place on the
/// screen.
ViewVertex view_vertex(const Vec3<World>& world_position, const ViewContext& view);
/// The same of all vertices.
void transform_to_view(std::span<const WorldVertex> world_vertices, const ViewContext& view,
                       std::vector<ViewVertex>& view_vertices);

/// Clips a triangle to the view and projects what is left: 3 to 7 corners, or none. `values` are those of its vertices.
void clip_and_project(const std::array<const ViewVertex*, 3>& triangle, const std::array<CornerValues, 3>& values,
                      const ViewContext& view, ClipScratch& scratch, std::vector<ScreenCorner>& polygon);

}  // namespace oblong

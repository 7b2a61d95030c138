#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/mesh_light.h"
#include "engine/mesh/placed_mesh.h"
#include "engine/view/clip.h"
#include "engine/view/outline.h"
#include "engine/view/view_context.h"

// A mesh's stages from object space to the screen, one function each, called in order by draw_mesh().

namespace oblong {

/// A vertex in the world.
struct WorldVertex {
    Vec3<World> position;
    Vec3<Unit> normal;
};

/// The largest 1/z of a mesh's corners: those nearer to the eye than 1/128 unit count as 1/128 unit away.
inline constexpr InverseZ kGreatestMeshInverseZ = InverseZ::from_int(128);
/// The largest texture coordinate; larger ones are clamped.
inline constexpr std::int32_t kMostTexel = 8'191;

/// The values at a corner that are interpolated over the screen. `light` is ambient_and_point_light() with
/// Shading::Phong, otherwise a row of the colormap plus 1/2, so that its floor is the nearest row.
struct CornerValues {
    Texel u, v;
    Fixed<std::int64_t, 16> light;
    Vec3<Unit> normal;  ///< for Shading::Phong
};

/// A place on the screen.
struct ScreenPlace {
    ScreenVertex screen;
    InverseZ inverse_z;
};

/// A vertex in viewspace and, where outcode is 0, on the screen.
struct ViewVertex : ScreenPlace {
    Vec3<View> position;
    std::uint8_t outcode = 0;
};

/// A corner on the screen.
struct ScreenCorner : ScreenPlace {
    CornerValues values;
};

/// The vertices in object space, of one frame or interpolated between two (into `scratch`).
std::span<const MeshVertex> pose_of(const PlacedMesh& placed, std::vector<MeshVertex>& scratch);

/// The numbers of the triangles that face the eye, tested in object space before any vertex is transformed: the eye is
/// in front of a triangle if N . (eye - A) > 0, N = (C - A) x (B - A). Triangles of missing vertices are left out.
void find_facing(std::span<const MeshTriangle> triangles, std::span<const MeshVertex> object_vertices,
                 const Vec3<World>& object_eye, std::vector<std::uint32_t>& facing);
/// The same by the triangles' planes. The eye is within 2^17 units along each axis (is_near_enough()).
void find_facing(std::span<const FacingPlane> planes, const Vec3<World>& object_eye,
                 std::vector<std::uint32_t>& facing);
bool is_near_enough(const Vec3<World>& object_eye);

/// Transforms the eye to object space; saturates.
Vec3<World> to_object(const Vec3<World>& world_eye, const MeshTransform& transform);

/// Transforms a point from object space to the world; saturates.
Vec3<World> world_position(const Vec3<World>& object_position, const MeshTransform& transform);
/// Transforms a normal from object space to the world by the inverse transpose, and normalises it. If all axes have the
/// same scale, the rotation alone is used; the error is at most 3 steps (2^-30).
Vec3<Unit> world_normal(const Vec3<Unit>& object_normal, const MeshTransform& transform);

/// The normal of a triangle in the world, of length 1; for Shading::Flat.
Vec3<Unit> world_normal(const MeshTriangle& triangle, std::span<const MeshVertex> object_vertices,
                        const MeshTransform& transform);

/// From object space to viewspace in one product.
struct MeshToView {
    using Coefficient = Fixed<std::int32_t, 26>;
    bool is_usable = false;  ///< false for large scales and adjusted views: points go through the world
    std::array<Vec3<Coefficient>, 3> rows;
    Vec3<Fixed<std::int64_t, 38>> origin;  ///< of object space
};
MeshToView make_mesh_to_view(const Vec3<World>& world_origin, const MeshTransform& transform, const ViewContext& view);

/// A box of object space that holds both boxes; `to_view` is usable.
ViewBox view_box_of(const MeshBox& from, const MeshBox& to, const MeshToView& to_view);

/// Transforms from object space to viewspace and sets the outcode; if that is 0, also projects.
void view_vertex(const Vec3<World>& object_position, const MeshTransform& transform, const MeshToView& to_view,
                 const ViewContext& view, ViewVertex& seen);

/// Clips a triangle to the view and projects it: 3 to 7 corners, or none. `values` belong to its vertices; null:
/// the corners' are not needed.
void clip_and_project(const std::array<const ViewVertex*, 3>& triangle,
                      const std::array<const CornerValues*, 3>& values, const ViewContext& view, ClipScratch& scratch,
                      std::vector<ScreenCorner>& polygon);

}  // namespace oblong

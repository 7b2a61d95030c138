#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"

namespace oblong {

/// A mesh's texture: rows top to bottom, one palette index a texel.
struct Skin {
    std::string name;
    std::int32_t width = 0, height = 0;
    std::vector<std::uint8_t> texels;
    bool has_holes = false;  ///< texels of kHoleTexel are not drawn
};

/// A vertex in one frame of a mesh, in object space: x ahead, y left, z up.
struct MeshVertex {
    Vec3<World> position;
    Vec3<Unit> normal;  ///< outward, of length 1
};

/// A vertex's texture coordinates, in texels; the same in all frames.
struct MeshTexel {
    Texel u, v;
};

/// Vertex numbers, clockwise seen from the front.
struct MeshTriangle {
    std::array<std::uint32_t, 3> vertices;
    std::uint32_t skin = 0;
};

/// The plane of a triangle in object space, to find out whether it faces the eye: N . eye > N . A.
struct FacingPlane {
    Vec3<Fixed<std::int32_t, 24>> normal;  ///< N = (C - A) x (B - A)
    Fixed<std::int64_t, 36> distance;      ///< N . A
};

struct MeshBox {
    Vec3<World> mins, maxs;
    bool operator==(const MeshBox&) const = default;
};

/// A part of a mesh is this many consecutive triangles; the last part may have fewer.
inline constexpr std::size_t kPartTriangles = 64;

struct MeshFrame {
    std::string name;
    std::vector<MeshVertex> vertices;
    Vec3<World> mins, maxs;           ///< box of its vertices
    std::vector<MeshBox> parts = {};  ///< box of each part; empty: unknown
};

/// Consecutive frames or skins shown in turn, or a single one.
struct MeshSequence {
    std::uint32_t first = 0;
    std::vector<std::int32_t> ends_ms;  ///< end of each in a cycle: ascending, the last above 0; or empty
};

/// The frame or skin shown at a time, which may be negative.
std::uint32_t shown_at(const MeshSequence& sequence, std::int64_t time_ms);

/// A model of triangles with its frames of animation. Every frame has as many vertices as `texels`.
struct Mesh {
    std::vector<MeshFrame> frames;
    std::vector<MeshTexel> texels;
    std::vector<MeshTriangle> triangles;
    std::vector<FacingPlane> planes = {};    ///< of all triangles in the only frame; or empty (facing_planes)
    std::vector<std::uint32_t> places = {};  ///< of all vertices in the only frame; or empty (shared_places)
    std::vector<Skin> skins;
    std::vector<MeshSequence> frame_sequences, skin_sequences;  ///< the file's frames and skins
    bool turns = false;                                         ///< always rotates (Quake's EF_ROTATE)
};

/// Limits of the mesh readers.
inline constexpr std::size_t kMostMeshTriangles = std::size_t{1} << 21, kMostMeshVertices = std::size_t{1} << 21,
                             kMostFrameVertices = std::size_t{1} << 24;  ///< the last in all frames together
inline constexpr std::int32_t kMeshLimit = 1 << 15;                      ///< units: coordinates are below it

/// Sets a frame's normals from its positions: at each vertex the normalised sum of its triangles' normals, weighted by
/// area. If they cancel, the normal of one triangle; if there is no triangle, up. `corners` are vertex numbers.
void set_normals(std::vector<MeshVertex>& vertices, std::span<const std::array<std::uint32_t, 3>> corners);

/// Sets the bounding box of a frame's vertices, empty at the origin if there are none; and the boxes of the parts of
/// `triangles`, if more than one.
void set_boxes(MeshFrame& frame, std::span<const MeshTriangle> triangles = {});

/// The planes of a mesh's triangles. Empty if it has several frames, or triangles of missing vertices, or of so many
/// units that a normal does not fit.
std::vector<FacingPlane> facing_planes(const Mesh& mesh);

/// The first vertex with the same position as each: hard edges and seams have several, and drawing places only this
/// one. Empty if a mesh has several frames.
std::vector<std::uint32_t> shared_places(const Mesh& mesh);

/// Reads a Quake model, an MDL file ("IDPO", version 6), enlarged by `scale` (above 0, at most 4,096).
///
/// A vertex on the seam that is used by triangles of the skin's back half becomes two vertices. Texture coordinates are
/// texel centres; those outside the skin, by at most its size, are clamped to its border. Normals are computed
/// (set_normals); the file's, which index a table of 162 directions, are ignored. Throws InputError naming the part of
/// the file and the offset for numbers that are not finite or too large, invalid indices, and counts that exceed the
/// file's size or kMostMeshTriangles and the other limits.
Mesh read_mdl(std::span<const std::uint8_t> bytes, World scale = World::from_int(1));

}  // namespace oblong

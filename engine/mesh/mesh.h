#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"

namespace oblong {

/// A picture that lies on a mesh: rows top to bottom, one palette index a texel.
struct Skin {
    std::string name;
    std::int32_t width = 0, height = 0;
    std::vector<std::uint8_t> texels;
};

/// A corner of triangles, as one frame of a mesh has it: in the mesh's own axes, which are the world's (x ahead, y
/// left, z up).
struct MeshVertex {
    Vec3<World> position;
    Vec3<Unit> normal;  ///< outward; of length 1
};

/// The skin's place that a vertex shows, texels; the same in all frames.
struct MeshTexel {
    Texel u, v;
};

/// Vertices by number, clockwise seen from the front.
struct MeshTriangle {
    std::array<std::uint32_t, 3> vertices;
    std::uint32_t skin = 0;
};

struct MeshBox {
    Vec3<World> mins, maxs;
    bool operator==(const MeshBox&) const = default;
};

/// How many triangles a part of a mesh has, one after the other; its last part perhaps fewer.
inline constexpr std::size_t kPartTriangles = 64;

struct MeshFrame {
    std::string name;
    std::vector<MeshVertex> vertices;
    Vec3<World> mins, maxs;           ///< the box of its vertices
    std::vector<MeshBox> parts = {};  ///< the box of each of the mesh's parts; none: not known
};

/// Consecutive frames or skins that take turns; or a single one, which stays.
struct MeshSequence {
    std::uint32_t first = 0;
    std::vector<std::int32_t> ends_ms;  ///< of each, from the start of a turn of all: rising, the last above 0; or none
};

/// The frame or skin that is shown at a time, which may be negative.
std::uint32_t shown_at(const MeshSequence& sequence, std::int64_t time_ms);

/// A model made of triangles, with the frames it moves in. Every frame has as many vertices as `texels`.
struct Mesh {
    std::vector<MeshFrame> frames;
    std::vector<MeshTexel> texels;
    std::vector<MeshTriangle> triangles;
    std::vector<Skin> skins;
    std::vector<MeshSequence> frame_sequences, skin_sequences;  ///< what its file counts as frames and skins
    bool turns = false;  ///< its file asks that it be shown turning (Quake's EF_ROTATE)
};

/// What readers of meshes accept.
inline constexpr std::size_t kMostMeshTriangles = std::size_t{1} << 21, kMostMeshVertices = std::size_t{1} << 21,
                             kMostFrameVertices = std::size_t{1} << 24;  ///< the last: of all frames together
inline constexpr std::int32_t kMeshLimit = 1 << 15;                      ///< units: no coordinate reaches it

/// A frame's normals from its positions: at each vertex the sum of its triangles' normals, each as long as the
/// triangle is large, made 1 long. Where those cancel, the normal of one of them; up, where there is none. Corners are
/// numbers of positions.
void set_normals(std::vector<MeshVertex>& vertices, std::span<const std::array<std::uint32_t, 3>> corners);

/// The least box around a frame's vertices, empty at the origin if there are none; and those of the parts that some
/// triangles make, if more than one. Their vertices are the frame's.
void set_boxes(MeshFrame& frame, std::span<const MeshTriangle> triangles = {});

/// A Quake model: the bytes of an MDL file ("IDPO", version 6), `scale` times as large (above 0, at most 4,096).
///
/// A vertex of the seam that triangles of the skin's back half use is two vertices of the mesh. Places on the skin are
/// those of texels' middles; the ones outside of it, up to as far as it is large, are put onto its border. Normals
/// are computed (set_normals), the file's, which are numbers of a table of 162 directions, are not read. Throws
/// InputError that names the part of the file and the offset: for numbers that are not finite or too large, indices
/// that lead nowhere, counts that the file is too short for or that exceed kMostMeshTriangles and its like.
Mesh read_mdl(std::span<const std::uint8_t> bytes, World scale = World::from_int(1));

}  // namespace oblong

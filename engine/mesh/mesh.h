#pragma once

#include <array>
#include <cstdint>
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

struct MeshFrame {
    std::string name;
    std::vector<MeshVertex> vertices;
    Vec3<World> mins, maxs;  ///< the box of its vertices
};

/// A model made of triangles, with the frames it moves in. Every frame has as many vertices as `texels`.
struct Mesh {
    std::vector<MeshFrame> frames;
    std::vector<MeshTexel> texels;
    std::vector<MeshTriangle> triangles;
    std::vector<Skin> skins;
};

}  // namespace oblong

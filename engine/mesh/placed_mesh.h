#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/fixed/angle.h"
#include "engine/level/level.h"
#include "engine/math/matrix.h"
#include "engine/mesh/mesh.h"

namespace oblong {

/// Where a mesh's light is worked out: once a triangle; at its vertices, with shades that go evenly from one to the
/// next (Gouraud 1971); or at each pixel, with normals that go evenly, and highlights (Phong 1975).
enum class Shading : std::uint8_t { Flat, Gouraud, Phong };

/// A mesh at its place in the world.
struct PlacedMesh {
    const Mesh* mesh = nullptr;               ///< outlives the frame; null, or without frames: nothing is drawn
    std::uint32_t frame = 0, next_frame = 0;  ///< beyond the last one: the last one
    std::int32_t blend_256 = 0;               ///< from `frame`, 0, to `next_frame`, 256
    std::uint32_t skin = 0;                   ///< is added to the triangles' own
    std::uint8_t colour = 15;                 ///< of triangles whose skin the mesh does not have
    Vec3<World> position;                     ///< of the mesh's origin
    Angle yaw, pitch, roll;                   ///< as a camera's
    Vec3<Entry> scale{kOne, kOne, kOne};      ///< along the mesh's own axes; above 0
    Shading shading = Shading::Gouraud;
    std::int32_t highlight = 0;    ///< of Shading::Phong: a lightmap value, added where it is brightest
    std::int32_t least_light = 0;  ///< a lightmap value: of what glows by itself

    static constexpr Entry kOne = Entry::from_int(1);
};

/// Its transform: object space to world, for points and for normals, and the way back.
struct MeshTransform {
    Matrix4 to_world;
    Matrix3 normals;  ///< the inverse transpose of its upper left part
    Matrix4 to_object;
    bool has_small_entries = false;                 ///< those of to_world, but for its last column, are below 2^5
    std::optional<std::array<Vec3<Unit>, 3>> turn;  ///< rows; where all axes are scaled alike it does for `normals`
};

/// Scale, then rotation, then translation. None where it has no inverse, or turns the mesh inside out.
std::optional<MeshTransform> make_mesh_transform(const PlacedMesh& placed);

/// Boxes in the world of one frame, or of two blended ones: whole units, rounded outward, one unit more.
class WorldBoxes {
  public:
    /// The mesh outlives it, and has a frame.
    explicit WorldBoxes(const PlacedMesh& placed);

    LevelBox whole() const;
    /// How many parts the mesh has, each with a box: perhaps none.
    std::size_t part_count() const;
    LevelBox of_part(std::size_t part) const;

  private:
    const PlacedMesh& placed_;
    Matrix4 to_world_;
};

/// What turning_box() depends on.
struct TurningShape {
    Vec3<World> position;
    Vec3<Entry> scale;
    std::array<MeshBox, 2> boxes;  ///< of its frames
    bool operator==(const TurningShape&) const = default;
};
TurningShape turning_shape(const PlacedMesh& placed);

/// A box that holds WorldBoxes::whole(), however the mesh is turned.
LevelBox turning_box(const TurningShape& shape);

/// The frames that it shows. The mesh has at least one.
const MeshFrame& frame_of(const PlacedMesh& placed);
const MeshFrame& next_frame_of(const PlacedMesh& placed);

}  // namespace oblong

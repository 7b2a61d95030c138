#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/fixed/trig.h"
#include "engine/level/level.h"
#include "engine/math/matrix.h"
#include "engine/mesh/mesh.h"

namespace oblong {

/// Where a mesh's light is computed: once a triangle; at the vertices, with interpolated shades (Gouraud 1971); or at
/// each pixel, with interpolated normals and highlights (Phong 1975).
enum class Shading : std::uint8_t { Flat, Gouraud, Phong };

/// A mesh at its place in the world.
struct PlacedMesh {
    const Mesh* mesh = nullptr;               ///< outlives the frame; null or without frames: nothing is drawn
    std::uint32_t frame = 0, next_frame = 0;  ///< clamped to the last one
    std::int32_t blend_256 = 0;               ///< from `frame` (0) to `next_frame` (256)
    std::uint32_t skin = 0;                   ///< added to the triangles' skin numbers
    std::uint8_t colour = 15;                 ///< of triangles whose skin is missing
    Vec3<World> position;                     ///< of the mesh's origin
    Angle yaw, pitch, roll;                   ///< as a camera's
    Vec3<Entry> scale{kOne, kOne, kOne};      ///< along the axes of object space; above 0
    Shading shading = Shading::Gouraud;
    std::int32_t highlight = 0;    ///< for Shading::Phong: its largest value, a lightmap value
    std::int32_t least_light = 0;  ///< a lightmap value, for what glows

    static constexpr Entry kOne = Entry::from_int(1);
    bool operator==(const PlacedMesh&) const = default;
};

/// The transforms from object space to the world and back.
struct MeshTransform {
    Matrix4 to_world;
    Matrix3 normals;  ///< the inverse transpose of to_world's upper left part
    Matrix4 to_object;
    bool has_small_entries = false;                 ///< in to_world all but the last column are below 2^4
    std::optional<std::array<Vec3<Unit>, 3>> turn;  ///< rotation rows; used for normals if all scales are equal
};

/// Scale, then rotation, then translation. None if it has no inverse or turns the mesh inside out.
std::optional<MeshTransform> make_mesh_transform(const PlacedMesh& placed);

/// The bounding box in the world of a frame or of two blended frames: whole units, rounded outward, plus one unit. The
/// mesh has a frame.
LevelBox world_box(const PlacedMesh& placed);
/// That of a part in two frames. `to_world`: MeshTransform's.
LevelBox world_box(const Matrix4& to_world, const MeshBox& from, const MeshBox& to);

/// The arguments of turning_box().
struct TurningShape {
    Vec3<World> position;
    Vec3<Entry> scale;
    std::array<MeshBox, 2> boxes;  ///< of the two frames
    bool operator==(const TurningShape&) const = default;
};
TurningShape turning_shape(const PlacedMesh& placed);

/// A box that holds world_box() for any rotation of the mesh.
LevelBox turning_box(const TurningShape& shape);

/// The frames shown. The mesh has at least one.
const MeshFrame& frame_of(const PlacedMesh& placed);
const MeshFrame& next_frame_of(const PlacedMesh& placed);

}  // namespace oblong

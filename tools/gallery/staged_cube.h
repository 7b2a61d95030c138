#pragma once

#include <string>
#include <vector>

#include "engine/mesh/draw_mesh.h"
#include "tools/gallery/row.h"

namespace oblong {

/// The stage after which the pipeline stops. Facing is tested first, in object space, so that back faces cost nothing
/// else.
enum class Stage { Object, Facing, InWorld, Lit, InView, Clipped, Divided, Projected, Scanned, Spans, Pixels };
inline const std::vector<std::string> kStageNames{"object space", "facing",  "world space", "lit",
                                                  "view space",   "clipped", "divided",     "on screen",
                                                  "scanned",      "spans",   "pixels"};

/// A triangle in the pipeline: its light, and the results of clipping and scan conversion.
struct ShownTriangle {
    std::uint32_t number = 0;
    Vec3<Unit> world_normal;
    double light = 0;                  ///< a lightmap value
    std::vector<Vec3<Entry>> divided;  ///< its corners in the canonical volume, after the perspective divide
    std::vector<ScreenCorner> corners;
    std::vector<Span> spans;
};

/// The cube's position: the distances east of and above the eye, which is at the origin.
inline constexpr double kCubeAhead = 4.6, kCubeBelow = -2.4;
/// The depths of the canonical volume.
inline constexpr double kVolumeNear = 0.25, kVolumeFar = 16;

/// The results of all stages for a cube, by the engine's own functions in order. The row's values: a stage, the cube's
/// yaw in degrees, and its offset to the left in quarters of a unit.
struct StagedCube {
    StagedCube(const RowInput& input, Framebuffer part);
    StagedCube(const StagedCube&) = delete;

    bool faces_eye(std::uint32_t triangle) const;
    /// World to the canonical volume.
    Matrix4 to_volume() const;
    /// The numbers after a stage, below a caption.
    std::vector<std::string> lines_of(Stage stage) const;

    Mesh mesh;
    PlacedMesh placed;
    ViewContext view;
    Vec3<World> object_eye;
    MeshLight light;
    MeshScratch scratch;
    std::vector<ShownTriangle> triangles;
};

}  // namespace oblong

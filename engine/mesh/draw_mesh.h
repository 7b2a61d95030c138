#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/mesh/mesh_pixels.h"

namespace oblong {

/// How far a vertex came on its way to the screen.
enum class VertexStage : std::uint8_t { Unknown, Seen, Complete };

/// What the stages of a mesh make, one after the other; kept from mesh to mesh, so that little is allocated.
struct MeshScratch {
    explicit MeshScratch(std::int32_t height_px) : rows(height_px) {}

    /// Before a mesh of so many vertices, none of them worked out.
    void begin(std::size_t vertex_count);

    const PlacedMesh* begun = nullptr;  ///< is_seen() left off here, and draw_mesh() goes on; null: neither
    MeshTransform transform;
    std::optional<std::int32_t> highlight;  ///< that `highlights` is of; none: not made yet
    HighlightTable highlights;
    std::vector<MeshVertex> object_vertices;  ///< between two frames
    std::vector<std::uint32_t> facing;        ///< triangles
    std::vector<WorldVertex> world_vertices;
    std::vector<ViewVertex> view_vertices;
    std::vector<CornerValues> values;  ///< of the vertices
    std::vector<VertexStage> stages;   ///< of the vertices: what of the three above is known
    ClipScratch clip;
    std::vector<ScreenCorner> polygon;  ///< of one triangle
    ScanlineExtents rows;
    std::vector<Span> spans;
};

/// The numbers of a mesh's parts that are drawn, rising; none: all of it.
using MeshParts = std::span<const std::uint32_t>;

/// How meshes are drawn.
struct MeshDrawing {
    const ViewContext& view;
    const Colormap& colormap;
    MeshLight light;
    const std::uint8_t* after = nullptr;  ///< MeshPaint::after
    bool is_affine = false;               ///< textures without perspective within a triangle, as in Quake's models
    MeshParts parts = {};
};

/// Whether draw_mesh() would draw a pixel. If so, the next mesh that is drawn with this scratch is this one, as it is
/// and in this view, or `begun` is reset before.
bool is_seen(const PlacedMesh& placed, MeshParts parts, const ViewContext& view, const MeshTarget& target,
             MeshScratch& scratch);

/// What drawing a mesh took.
struct MeshCounts {
    std::int64_t facing = 0;     ///< triangles that face the eye
    std::int64_t triangles = 0;  ///< that cover pixels, after clipping
    std::int64_t pixels = 0;     ///< drawn, some of them more than once
};

/// The values of a vertex that go over the screen: texels, and the light or what it is worked out from at each pixel.
CornerValues corner_values(const PlacedMesh& placed, std::size_t number, const WorldVertex& vertex,
                           const MeshLight& light);

/// Draws a mesh where nothing is nearer, and sets the depth of its pixels. Any mesh and place: what cannot be drawn (no
/// frames, a scale without inverse, numbers of missing vertices) is left out.
MeshCounts draw_mesh(const PlacedMesh& placed, const MeshDrawing& drawing, const MeshTarget& target,
                     MeshScratch& scratch);

}  // namespace oblong

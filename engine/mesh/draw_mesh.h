#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/mesh/mesh_pixels.h"

namespace oblong {

/// Which stages a vertex has passed.
enum class VertexStage : std::uint8_t { Unknown, Transformed, Complete };

/// The results of one triangle's stages.
struct TriangleScratch {
    explicit TriangleScratch(std::int32_t height_px) : rows(height_px) {}

    std::array<CornerValues, 3> flat;  ///< with Shading::Flat
    ClipScratch clip;
    std::vector<ScreenCorner> polygon;  ///< the clipped triangle
    ScanlineExtents rows;
    std::vector<Span> spans;
    Barycentric weights;
    LinearQuantity<InverseZ> inverse_z;
};

/// The results of a mesh's stages; kept from mesh to mesh to save allocations.
struct MeshScratch {
    explicit MeshScratch(std::int32_t height_px) : triangle(height_px) {}

    /// Resets the stages of `vertex_count` vertices.
    void begin(std::size_t vertex_count);

    const PlacedMesh* begun = nullptr;  ///< the mesh that any_in_view() began and draw_mesh() continues; or null
    MeshTransform transform;
    MeshToView to_view;
    std::optional<std::int32_t> highlight;  ///< of `highlights`; none: not made yet
    HighlightTable highlights;
    std::vector<MeshVertex> object_vertices;  ///< interpolated between two frames
    std::vector<std::uint32_t> facing;        ///< triangles
    std::vector<WorldVertex> world_vertices;
    std::vector<ViewVertex> view_vertices;
    std::vector<CornerValues> values;  ///< of vertices
    std::vector<VertexStage> stages;   ///< of vertices: which of the three above are set
    TriangleScratch triangle;
};

/// The parts of a mesh to draw, in ascending order; empty: all.
using MeshParts = std::span<const std::uint32_t>;

/// How meshes are drawn.
struct MeshDrawing {
    const ViewContext& view;
    const Colormap& colormap;
    MeshLight light;
    const std::uint8_t* colours = nullptr;  ///< MeshPaint::colours
    bool is_affine = false;                 ///< texture mapping without perspective, as in Quake's models
    MeshParts parts = {};
    const MeshTransform* transform = nullptr;  ///< the mesh's; null: not known
};

/// A question about a triangle in view that faces the eye, clipped.
using AskTriangle = std::function<bool(const std::array<const ScreenPlace*, 3>&)>;

/// Whether a question is answered with yes for a triangle of a mesh. If so, the next mesh asked about or drawn with
/// this scratch must be this one, unchanged and in this view, or `begun` must be reset. `transform` is the mesh's.
bool any_in_view(const PlacedMesh& placed, MeshParts parts, const MeshTransform& transform, const ViewContext& view,
                 MeshScratch& scratch, const AskTriangle& asks);

/// Whether draw_mesh() would draw a pixel; the same holds as for any_in_view().
bool is_seen(const PlacedMesh& placed, MeshParts parts, const MeshTransform& transform, const ViewContext& view,
             const MeshTarget& target, MeshScratch& scratch);

/// Counts of one draw_mesh().
struct MeshCounts {
    std::int64_t facing = 0;     ///< triangles that face the eye
    std::int64_t triangles = 0;  ///< after clipping, those that cover pixels
    std::int64_t pixels = 0;     ///< drawn, including overdraw
};

/// The values of a vertex that are interpolated over the screen.
CornerValues corner_values(const PlacedMesh& placed, std::size_t number, const WorldVertex& vertex,
                           const MeshLight& light);

/// Draws a mesh where nothing is nearer, and sets the depth of its pixels. Accepts any mesh and place: what cannot be
/// drawn (no frames, a scale without inverse, triangles of missing vertices) is left out.
MeshCounts draw_mesh(const PlacedMesh& placed, const MeshDrawing& drawing, const MeshTarget& target,
                     MeshScratch& scratch);

}  // namespace oblong

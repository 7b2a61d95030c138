#pragma once

#include "engine/mesh/draw_mesh.h"
#include "engine/mesh/mesh.h"
#include "tools/gallery/row.h"

namespace oblong {

/// A canvas in which meshes are drawn by the engine's stages, seen from the origin of the world along its x axis (y
/// left, z up), in the middle of the canvas.
class MeshScene {
  public:
    MeshScene(const RowInput& input, Framebuffer canvas, int field_of_view = 60);

    /// `colormap`: instead of the gallery's.
    MeshCounts draw(const PlacedMesh& placed, const MeshLight& light, const Colormap* colormap = nullptr);
    const ViewContext& view() const { return view_; }

  private:
    const Colormap& colormap_;
    ViewContext view_;
    DepthBuffer depth_;
    Framebuffer canvas_;
    MeshScratch scratch_;
};

/// A mesh at a place.
inline PlacedMesh placed_mesh(const Mesh& mesh, const Vec& position, Shading shading) {
    PlacedMesh placed;
    placed.mesh = &mesh;
    placed.position = world_point(position);
    placed.shading = shading;
    return placed;
}

/// The nearest of the palette's colours that light changes.
std::uint8_t lit_colour(const GalleryAssets& assets, Rgb8 colour);

/// A colormap that gives a pixel the number of its shade.
Colormap shade_numbers();

/// The shade of a lightmap value of any size, by Colormap's definition.
double exact_shade(double light);

/// A corner of a mesh in doubles, and its screen position.
struct ExactCorner {
    Vec screen, position, normal;
};
/// The visible triangle at a screen position, the position's barycentric coordinates on the screen, and the face
/// normal.
struct ExactHit {
    std::array<ExactCorner, 3> corners;
    std::array<double, 3> shares;
    Vec normal;
};
/// Tests all triangles of the mesh, in doubles; the mesh is placed and scaled, but not turned.
std::optional<ExactHit> exact_hit(const PlacedMesh& placed, const RowInput& input, int field_of_view, double column,
                                  double row);

/// Squares of 8 texels in two colours, `size` texels a side.
Skin checkered_skin(std::int32_t size, std::uint8_t one, std::uint8_t other);
/// One texel.
Skin plain_skin(std::uint8_t colour);

/// A ball around the origin: `rings` from pole to pole, twice as many sectors around. The skin goes around once.
Mesh ball_mesh(double radius, int rings, Skin skin);

/// A cube around the origin, each side with the whole skin and its own normals.
Mesh cube_mesh(double half_size, Skin skin);

}  // namespace oblong

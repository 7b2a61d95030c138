// All that the five seeds name, and the rows of the gallery that show it: nothing is left out.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tools/gallery/rows.h"

namespace oblong {
namespace {

struct Named {
    const char* what;
    std::vector<std::string_view> rows;
};

const std::vector<Named> kNamed{
    // 1 Muratori
    {"aspect from display and mode", {"pixel-aspect"}},
    {"field of view, distance to the viewplane, the same view at every resolution", {"field-of-view"}},
    {"two precomputed multipliers", {"two-multipliers"}},
    {"no more cost than the naive projection", {"two-multipliers"}},
    {"the dot product as definition and operation", {"dot-product", "dot-product-steps"}},
    {"orthonormal bases, and what breaks without", {"orthonormal-axes"}},
    // 2 Lab
    {"log channels by kind", {"log"}},
    {"memory checking", {"memory"}},
    {"arbitrary rotation by quaternions", {"rotations"}},
    {"homogeneous 4-vectors and 4x4 matrices", {"homogeneous", "model-to-world"}},
    {"orthographic and perspective views", {"orthographic", "vanishing-points"}},
    {"VRP, VPN, VUP, COP, window; the cube's table", {"view-window"}},
    {"front and back planes", {"front-plane"}},
    {"the canonical view volume, lines clipped in it", {"view-volume", "lines-clipped"}},
    {"zoom against dolly", {"zoom-dolly", "view-window"}},
    // 3 Notes
    {"model, world, camera, screen space", {"pipeline"}},
    {"left-handed, clockwise", {"left-handed-cube"}},
    {"lines: naive, DDA, Bresenham, Gupta-Sproull", {"lines"}},
    {"triangles with flat top and bottom; edge functions in parallel", {"triangles"}},
    {"painter's algorithm", {"hidden-surfaces", "overdraw", "cyclic-overlap"}},
    {"z-buffer", {"z-buffer"}},
    {"scale, translate, rotate, projection matrices", {"model-to-world", "projection-matrix"}},
    {"flat, Gouraud, Phong shading", {"shading"}},
    {"textures from PNG", {"texture-quantise"}},
    {"barycentric coordinates and gradients", {"barycentric", "perspective-correct"}},
    {"look-at and FPS cameras", {"cameras"}},
    {"clipping against six planes", {"view-volume", "two-lists"}},
    {"polygon to triangles", {"triangulate"}},
    {"top-left rule", {"top-left-rule"}},
    // 4 Princeton
    {"the order of the stages with direct illumination in the world", {"mesh-pipeline"}},
    {"the OpenGL example", {"opengl-quad"}},
    {"parallel and perspective view volumes", {"view-volume"}},
    {"the perspective matrix, D < 0", {"homogeneous"}},
    {"orthographic front, top, side", {"orthographic"}},
    {"isometric, dimetric, trimetric", {"axonometric", "level-from-outside"}},
    {"cavalier, cabinet", {"oblique"}},
    {"one, two, three vanishing points", {"vanishing-points"}},
    {"viewing matrix from the camera's vectors and its inverse", {"camera-matrix"}},
    {"meshes through the whole pipeline", {"mesh-pipeline", "mesh-in-level"}},
    {"ray casting", {"ray-casting"}},
    // 5 Abrash
    {"lighting by dot products", {"lighting-by-dot-product", "lights"}},
    {"back-face culling in objectspace, and why viewspace normals mislead", {"culling"}},
    {"normals of scaled models", {"normals"}},
    {"point to plane distance; line against plane", {"line-and-plane", "picking"}},
    {"new axes by cross product", {"cross-product"}},
    {"rotation by projection onto axes", {"rotation-by-projection"}},
    {"a BSP renderer", {"tree-order"}}};

TEST(GalleryTable, ShowsAllThatTheSeedsName) {
    std::set<std::string_view> ids;
    for (const Row& row : gallery_rows()) ids.insert(row.id);
    for (const Named& named : kNamed)
        for (const std::string_view id : named.rows) EXPECT_TRUE(ids.contains(id)) << named.what << ": " << id;
}

}  // namespace
}  // namespace oblong

// All that the five seeds name, and the rows of the gallery that show it: nothing is left out.
// The row that stops the pipeline after each stage: what one stage counts, the next one draws.

#include <gtest/gtest.h>

#include <set>

#include "tests/gallery/gallery_fixture.h"
#include "tools/gallery/row.h"

namespace oblong::test {
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
    {"VRP, VPN, COP, window, F and B to the canonical view volume", {"volume-steps"}},
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
    {"look-at and FPS cameras; look-at times translate", {"cameras", "camera-matrix"}},
    {"cross2d's sign", {"barycentric"}},
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

constexpr std::int64_t kStages = 11, kSpans = 9, kPixels = 10;

class PipelineRow : public GalleryTest {
  protected:
    /// The pixels of the scene, left of the numbers, that are not of the background's colour (that of the corner).
    static std::int64_t drawn_pixels(const Drawn& drawn) {
        const auto pixel = [&](std::int32_t x, std::int32_t y) {
            return item(drawn.pixels, (y + kBorder_px) * (320 + 2 * kBorder_px) + x + kBorder_px);
        };
        std::int64_t count = 0;
        for (std::int32_t y = kHeader_px; y < 200 - kFooter_px; ++y)
            for (std::int32_t x = 0; x < 188; ++x) count += pixel(x, y) != pixel(187, 200 - kFooter_px - 1);
        return count;
    }
    static std::int64_t span_pixels(const Drawn& drawn) {
        for (const Figure& figure : drawn.figures)
            if (figure.name == "pixels of all spans") return std::stoll(figure.found);
        return -1;
    }
};

TEST_F(PipelineRow, PixelsAreThoseOfTheSpansEachOnce) {
    const Row row = stage_rows().front();
    for (const std::int64_t yaw : {0, 20, 60})
        for (const std::int64_t left : {-10, -3, 0, 5, 10}) {
            const Drawn drawn = draw(row, {kPixels, yaw, left});
            EXPECT_GT(span_pixels(drawn), 1000);
            EXPECT_EQ(drawn_pixels(drawn), span_pixels(drawn)) << yaw << " " << left;
        }
}

TEST_F(PipelineRow, EveryStageHasAPictureOfItsOwn) {
    const Row row = stage_rows().front();
    ASSERT_EQ(row.parameters[0].most, kStages - 1);
    for (std::int64_t stage = 0; stage + 1 < kStages; ++stage)
        EXPECT_NE(draw(row, {stage, 30, 7}).pixels, draw(row, {stage + 1, 30, 7}).pixels) << stage;
}

/// Every second row is left out, so that one span is told from the next.
TEST_F(PipelineRow, SpansAreHalfOfThePixels) {
    const Drawn drawn = draw(stage_rows().front(), {kSpans, 30, 7});
    EXPECT_LE(std::abs(2 * drawn_pixels(drawn) - span_pixels(drawn)), 240);
}

}  // namespace
}  // namespace oblong::test

#include "engine/mesh/draw_mesh.h"

#include <algorithm>

#include "engine/base/table.h"

namespace oblong {

namespace {

Texel within_skins(Texel texel) {
    return std::clamp(texel, Texel{}, Texel::from_int(kMostTexel));
}

/// A shade for Colormap, its floor the nearest one.
Fixed<std::int64_t, 16> rounded_shade(Light8 light, const MeshLight& lights) {
    return Fixed<std::int64_t, 16>::from_raw(shade_16_of(light, lights.brightness_100) + (1 << 15));
}

/// Everything that is constant while a mesh is drawn.
struct MeshContext {
    const PlacedMesh& placed;
    const MeshDrawing& drawing;
    const MeshTarget& target;
    std::span<const MeshVertex> object_vertices;
    MeshTransform transform;
    HighlightTable highlight;
    Vec3<Unit> halfway;
    Skin plain;  ///< of triangles without a skin
};

bool is_whole(const Skin& skin) {
    return skin.width > 0 && skin.height > 0 && skin.texels.size() == pixel_count(skin.width, skin.height);
}

const Skin& skin_of(const MeshTriangle& triangle, const MeshContext& mesh) {
    const std::vector<Skin>& skins = mesh.placed.mesh->skins;
    const std::uint64_t number = std::uint64_t{triangle.skin} + mesh.placed.skin;
    return number < skins.size() && is_whole(at(skins, number)) ? at(skins, number) : mesh.plain;
}

/// One light for a whole triangle, that of its middle.
void set_flat_light(const MeshTriangle& triangle, const MeshContext& mesh, const MeshScratch& scratch,
                    std::array<CornerValues, 3>& values) {
    Vec3<WorldWide> sum;
    for (const std::uint32_t vertex : triangle.vertices)
        sum = sum + convert<WorldWide>(at(scratch.world_vertices, vertex).position);
    const auto third = [](WorldWide whole) { return World::from_raw(static_cast<World::Raw>(whole.raw / 3)); };
    const Vec3<Unit> normal = world_normal(triangle, mesh.object_vertices, mesh.transform);
    const MeshLight& light = mesh.drawing.light;
    const auto shade = rounded_shade(light_at({third(sum.x), third(sum.y), third(sum.z)}, normal, light), light);
    for (CornerValues& corner : values) corner.light = shade;
}

/// Draws a triangle of the screen; not one that covers no pixel's centre, or is seen from its back.
void draw_triangle(const std::array<const ScreenCorner*, 3>& corners, const MeshPaint& paint, const MeshContext& mesh,
                   MeshScratch& scratch, MeshCounts& counts) {
    scan_convex(std::array{corners[0]->screen, corners[1]->screen, corners[2]->screen}, scratch.rows);
    scratch.spans.clear();
    append_spans(scratch.rows, mesh.target.part, scratch.spans);
    if (scratch.spans.empty()) return;
    const auto triangle = make_shaded_triangle(corners, {paint.shading == Shading::Phong, paint.is_affine});
    if (!triangle) return;
    ++counts.triangles;
    counts.pixels += draw_mesh_spans(scratch.spans, triangle->gradients, paint, mesh.target);
}

/// Draws one triangle of the mesh: after clipping a fan of them.
void draw_polygon(const MeshTriangle& triangle, const MeshContext& mesh, MeshScratch& scratch, MeshCounts& counts) {
    std::array<const ViewVertex*, 3> corners{};
    std::array<CornerValues, 3> values;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = &at(scratch.view_vertices, triangle.vertices[i]);
        values[i] = at(scratch.values, triangle.vertices[i]);
    }
    const Shading shading = mesh.placed.shading;
    if (shading == Shading::Flat) set_flat_light(triangle, mesh, scratch, values);
    clip_and_project(corners, values, mesh.drawing.view, scratch.clip, scratch.polygon);

    const MeshDrawing& drawing = mesh.drawing;
    const MeshPaint paint{skin_of(triangle, mesh), drawing.colormap, drawing.light,   shading,
                          drawing.is_affine,       mesh.halfway,     &mesh.highlight, drawing.after};
    for (std::size_t i = 2; i < scratch.polygon.size(); ++i)
        draw_triangle({&scratch.polygon[0], &scratch.polygon[i - 1], &scratch.polygon[i]}, paint, mesh, scratch,
                      counts);
}

/// To the eye from the mesh's place, for highlights.
Vec3<Unit> toward_eye(const PlacedMesh& placed, const ViewContext& view) {
    return normalised(widening_difference(view.eye, placed.position));
}

}  // namespace

void find_corner_values(const PlacedMesh& placed, std::span<const WorldVertex> world_vertices, const MeshLight& light,
                        std::vector<CornerValues>& values) {
    const std::vector<MeshTexel>& texels = placed.mesh->texels;
    values.clear();
    for (std::size_t i = 0; i < world_vertices.size(); ++i) {
        const MeshTexel texel = i < texels.size() ? texels[i] : MeshTexel{};
        const auto& [position, normal] = world_vertices[i];
        CornerValues corner{within_skins(texel.u), within_skins(texel.v), {}, normal};
        if (placed.shading == Shading::Phong)
            corner.light = Fixed<std::int64_t, 16>::from_raw(std::int64_t{even_light(position, normal, light)} * 256);
        if (placed.shading == Shading::Gouraud) corner.light = rounded_shade(light_at(position, normal, light), light);
        values.push_back(corner);
    }
}

MeshCounts draw_mesh(const PlacedMesh& placed, const MeshDrawing& drawing, const MeshTarget& target,
                     MeshScratch& scratch) {
    MeshCounts counts;
    if (!placed.mesh || placed.mesh->frames.empty()) return counts;
    const std::optional<MeshTransform> transform = make_mesh_transform(placed);
    if (!transform) return counts;
    const MeshContext mesh{placed,
                           drawing,
                           target,
                           pose_of(placed, scratch.object_vertices),
                           *transform,
                           make_highlight_table(placed.highlight),
                           halfway(drawing.light.directional.toward, toward_eye(placed, drawing.view)),
                           {"", 1, 1, {placed.colour}}};
    find_facing(placed.mesh->triangles, mesh.object_vertices, to_object(drawing.view.eye, *transform), scratch.facing);
    transform_to_world(mesh.object_vertices, *transform, scratch.world_vertices);
    transform_to_view(scratch.world_vertices, drawing.view, scratch.view_vertices);
    find_corner_values(placed, scratch.world_vertices, drawing.light, scratch.values);
    for (const std::uint32_t triangle : scratch.facing)
        draw_polygon(at(placed.mesh->triangles, triangle), mesh, scratch, counts);
    counts.facing = std::ssize(scratch.facing);
    return counts;
}

}  // namespace oblong

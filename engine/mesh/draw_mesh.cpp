#include "engine/mesh/draw_mesh.h"

#include <algorithm>
#include <utility>

#include "engine/base/table.h"

namespace oblong {

namespace {

Texel within_skins(Texel texel) {
    return std::clamp(texel, Texel{}, Texel::from_int(kMostTexel));
}

/// A row of Colormap plus 1/2, so that its floor is the nearest row.
Fixed<std::int64_t, 16> rounded_shade(Light8 light, const MeshLight& lights) {
    return Fixed<std::int64_t, 16>::from_raw(shade_of(brightened(light, lights.brightness_100)) + (1 << 15));
}

/// Constant during any_in_view().
struct MeshPlacement {
    const PlacedMesh& placed;
    const ViewContext& view;
    std::span<const MeshVertex> object_vertices;
    std::span<const std::uint32_t> places;  ///< Mesh::places, or empty
    const MeshTransform& transform;
    const MeshToView& to_view;
};

/// Constant during draw_mesh().
struct MeshContext : MeshPlacement {
    const MeshTarget& target;
    const MeshDrawing& drawing;
    const HighlightTable& highlights;
    Vec3<Unit> halfway;
    Skin plain;  ///< for triangles without a skin
};

/// Begins a mesh, or continues after any_in_view(). None if it cannot be drawn. `transform` is the mesh's; null: not
/// known.
std::optional<MeshPlacement> place_mesh(const PlacedMesh& placed, const MeshTransform* transform,
                                        const ViewContext& view, MeshScratch& scratch) {
    if (!placed.mesh || placed.mesh->frames.empty()) return std::nullopt;
    const bool goes_on = std::exchange(scratch.begun, nullptr) == &placed;
    if (!goes_on) {
        const std::optional<MeshTransform> found = transform ? *transform : make_mesh_transform(placed);
        if (!found) return std::nullopt;
        scratch.transform = *found;
        scratch.to_view = make_mesh_to_view(placed.position, *found, view);
    }
    const std::span<const MeshVertex> pose = pose_of(placed, scratch.object_vertices);
    if (!goes_on) scratch.begin(pose.size());
    const std::vector<std::uint32_t>& places = placed.mesh->places;
    const std::span<const std::uint32_t> shared =
        places.size() == pose.size() ? places : std::span<const std::uint32_t>();
    return MeshPlacement{placed, view, pose, shared, scratch.transform, scratch.to_view};
}

bool is_whole(const Skin& skin) {
    return skin.width > 0 && skin.height > 0 && skin.texels.size() == pixel_count(skin.width, skin.height);
}

const Skin& skin_of(const MeshTriangle& triangle, const MeshContext& mesh) {
    const std::vector<Skin>& skins = mesh.placed.mesh->skins;
    const std::uint64_t number = std::uint64_t{triangle.skin} + mesh.placed.skin;
    return number < skins.size() && is_whole(item(skins, number)) ? item(skins, number) : mesh.plain;
}

/// The light of a whole triangle, that of its middle.
Fixed<std::int64_t, 16> flat_light(const MeshTriangle& triangle, const MeshContext& mesh, const MeshScratch& scratch) {
    Vec3<WorldWide> sum;
    for (const std::uint32_t vertex : triangle.vertices)
        sum = sum + convert<WorldWide>(item(scratch.world_vertices, vertex).position);
    const auto third = [](WorldWide whole) { return convert<World>(whole / 3); };
    const Vec3<Unit> normal = world_normal(triangle, mesh.object_vertices, mesh.transform);
    const MeshLight& light = mesh.drawing.light;
    return rounded_shade(light_at({third(sum.x), third(sum.y), third(sum.z)}, normal, light), light);
}

void transform_vertex(std::uint32_t number, const MeshPlacement& mesh, MeshScratch& scratch) {
    view_vertex(mesh.object_vertices[number].position, mesh.transform, mesh.to_view, mesh.view,
                item(scratch.view_vertices, number));
    item(scratch.stages, number) = VertexStage::Transformed;
}

/// A vertex in the view, computed on first use.
inline const ViewVertex& transformed_vertex(std::uint32_t number, const MeshPlacement& mesh, MeshScratch& scratch) {
    if (!mesh.places.empty()) number = mesh.places[number];
    if (item(scratch.stages, number) == VertexStage::Unknown) transform_vertex(number, mesh, scratch);
    return item(scratch.view_vertices, number);
}

std::array<const ViewVertex*, 3> transformed_vertices(const MeshTriangle& triangle, const MeshPlacement& mesh,
                                                      MeshScratch& scratch) {
    const auto& [a, b, c] = triangle.vertices;
    return {&transformed_vertex(a, mesh, scratch), &transformed_vertex(b, mesh, scratch),
            &transformed_vertex(c, mesh, scratch)};
}

/// Whether all of a triangle is inside the view.
bool is_inside(const std::array<const ViewVertex*, 3>& vertices) {
    return (vertices[0]->outcode | vertices[1]->outcode | vertices[2]->outcode) == 0;
}

/// Whether all of it is certainly outside.
bool is_outside(const std::array<const ViewVertex*, 3>& vertices) {
    return (vertices[0]->outcode & vertices[1]->outcode & vertices[2]->outcode) != 0;
}

/// Whether a triangle inside the view has a pixel's centre between its corners' rows, and one between their columns.
/// Few triangles of a distant mesh have.
bool may_cover_centre(const std::array<const ViewVertex*, 3>& vertices) {
    const auto& [a, b, c] = vertices;
    const auto differ = [](Screen x, Screen y, Screen z) {
        const std::int32_t first = first_centre_from(x);
        return first != first_centre_from(y) || first != first_centre_from(z);
    };
    return differ(a->screen.x, b->screen.x, c->screen.x) && differ(a->screen.y, b->screen.y, c->screen.y);
}

/// A vertex's values, computed on first use. Only lights at points ask where in the world it is.
const CornerValues& values_at(std::uint32_t number, const MeshContext& mesh, MeshScratch& scratch) {
    CornerValues& values = item(scratch.values, number);
    VertexStage& stage = item(scratch.stages, number);
    if (stage == VertexStage::Complete) return values;
    WorldVertex& vertex = item(scratch.world_vertices, number);
    const MeshVertex& object_vertex = mesh.object_vertices[number];
    if (!mesh.drawing.light.points.empty()) vertex.position = world_position(object_vertex.position, mesh.transform);
    vertex.normal = world_normal(object_vertex.normal, mesh.transform);
    values = corner_values(mesh.placed, number, vertex, mesh.drawing.light);
    stage = VertexStage::Complete;
    return values;
}

/// The values of a triangle's corners, valid until the next call.
std::array<const CornerValues*, 3> values_of(const MeshTriangle& triangle, const MeshContext& mesh,
                                             MeshScratch& scratch) {
    const auto& [a, b, c] = triangle.vertices;
    std::array values{&values_at(a, mesh, scratch), &values_at(b, mesh, scratch), &values_at(c, mesh, scratch)};
    if (mesh.placed.shading != Shading::Flat) return values;
    const auto light = flat_light(triangle, mesh, scratch);
    for (std::size_t i = 0; i < 3; ++i) {
        scratch.triangle.flat[i] = *values[i];
        scratch.triangle.flat[i].light = light;
        values[i] = &scratch.triangle.flat[i];
    }
    return values;
}

/// Sets the scratch's spans, weights and 1/z. False if the triangle covers no pixel's centre, is seen from its back, or
/// is hidden.
bool find_triangle(const std::array<const ScreenPlace*, 3>& corners, const MeshTarget& target, TriangleScratch& scratch,
                   MeshCounts& counts) {
    const std::array places{corners[0]->screen, corners[1]->screen, corners[2]->screen};
    find_triangle_spans(places, target.part, scratch.rows, scratch.spans);
    if (scratch.spans.empty() || !make_barycentric(corners, scratch.spans, scratch.weights)) return false;
    ++counts.triangles;
    scratch.inverse_z = inverse_z_over(scratch.weights);
    return !is_covered(scratch.spans, scratch.weights, scratch.inverse_z, target.depth);
}

MeshPaint paint_of(const MeshTriangle& triangle, const MeshContext& mesh) {
    const MeshDrawing& drawing = mesh.drawing;
    return {skin_of(triangle, mesh), drawing.colormap, drawing.light,    mesh.placed.shading,
            drawing.is_affine,       mesh.halfway,     &mesh.highlights, drawing.colours};
}

/// Draws the triangle of find_triangle().
void draw_triangle(const std::array<const CornerValues*, 3>& values, const MeshPaint& paint, const MeshTarget& target,
                   const TriangleScratch& found, MeshCounts& counts) {
    const GradientChoice choice{paint.shading == Shading::Phong, paint.is_affine};
    const MeshGradients gradients = make_mesh_gradients(found.weights, values, found.inverse_z, choice);
    counts.pixels += draw_mesh_spans(found.spans, gradients, paint, target);
}

/// Draws a triangle that is inside the view. Normals, light and texels of a vertex are computed only when a triangle
/// shows that uses it: most triangles of a small mesh do not.
void draw_whole(const MeshTriangle& triangle, const std::array<const ViewVertex*, 3>& vertices, const MeshContext& mesh,
                MeshScratch& scratch, MeshCounts& counts) {
    if (!find_triangle({vertices[0], vertices[1], vertices[2]}, mesh.target, scratch.triangle, counts)) return;
    draw_triangle(values_of(triangle, mesh, scratch), paint_of(triangle, mesh), mesh.target, scratch.triangle, counts);
}

/// Clips a triangle and draws the rest as a fan.
void draw_clipped(const MeshTriangle& triangle, const std::array<const ViewVertex*, 3>& vertices,
                  const MeshContext& mesh, MeshScratch& scratch, MeshCounts& counts) {
    TriangleScratch& work = scratch.triangle;
    clip_and_project(vertices, values_of(triangle, mesh, scratch), mesh.view, work.clip, work.polygon);
    const MeshPaint paint = paint_of(triangle, mesh);
    for (std::size_t i = 2; i < work.polygon.size(); ++i) {
        const ScreenCorner &a = work.polygon[0], &b = work.polygon[i - 1], &c = work.polygon[i];
        if (find_triangle({&a, &b, &c}, mesh.target, work, counts))
            draw_triangle({&a.values, &b.values, &c.values}, paint, mesh.target, work, counts);
    }
}

void draw_if_in_view(const MeshTriangle& triangle, const MeshContext& mesh, MeshScratch& scratch, MeshCounts& counts) {
    const std::array<const ViewVertex*, 3> vertices = transformed_vertices(triangle, mesh, scratch);
    if (is_outside(vertices)) return;
    if (!is_inside(vertices)) return draw_clipped(triangle, vertices, mesh, scratch, counts);
    if (may_cover_centre(vertices)) draw_whole(triangle, vertices, mesh, scratch, counts);
}

/// Whether a question is answered with yes for a part of a triangle in view.
bool any_of_triangle(const MeshTriangle& triangle, const MeshPlacement& mesh, MeshScratch& scratch,
                     const AskTriangle& asks) {
    const auto vertices = transformed_vertices(triangle, mesh, scratch);
    if (is_outside(vertices)) return false;
    if (is_inside(vertices)) return may_cover_centre(vertices) && asks({vertices[0], vertices[1], vertices[2]});
    std::vector<ScreenCorner>& polygon = scratch.triangle.polygon;
    clip_and_project(vertices, {}, mesh.view, scratch.triangle.clip, polygon);
    for (std::size_t i = 2; i < polygon.size(); ++i)
        if (asks({&polygon[0], &polygon[i - 1], &polygon[i]})) return true;
    return false;
}

/// Calls asks() for the triangles of some parts that face the eye until it returns true; returns whether it did.
template <class Ask>
bool any_facing(const MeshPlacement& mesh, MeshParts parts, MeshScratch& scratch, Ask asks) {
    const std::span<const MeshTriangle> all(mesh.placed.mesh->triangles);
    const std::span<const FacingPlane> planes(mesh.placed.mesh->planes);
    const Vec3<World> object_eye = to_object(mesh.view.eye, mesh.transform);
    const bool has_planes = planes.size() == all.size() && is_near_enough(object_eye);
    const auto any_of = [&](std::span<const MeshTriangle> triangles) {
        if (has_planes)
            find_facing(planes.subspan(as_size(triangles.data() - all.data()), triangles.size()), object_eye,
                        scratch.facing);
        else
            find_facing(triangles, mesh.object_vertices, object_eye, scratch.facing);
        return std::any_of(scratch.facing.begin(), scratch.facing.end(),
                           [&](std::uint32_t triangle) { return asks(triangles[triangle]); });
    };
    if (parts.empty()) return any_of(all);
    return std::any_of(parts.begin(), parts.end(), [&](std::uint32_t part) {
        const std::span<const MeshTriangle> rest = all.subspan(part * kPartTriangles);
        return any_of(rest.first(std::min(rest.size(), kPartTriangles)));
    });
}

/// The table of a mesh's highlights; arbitrary without Shading::Phong.
const HighlightTable& highlights_of(const PlacedMesh& placed, MeshScratch& scratch) {
    if (placed.shading == Shading::Phong && scratch.highlight != placed.highlight) {
        scratch.highlights = make_highlight_table(placed.highlight);
        scratch.highlight = placed.highlight;
    }
    return scratch.highlights;
}

}  // namespace

CornerValues corner_values(const PlacedMesh& placed, std::size_t number, const WorldVertex& vertex,
                           const MeshLight& light) {
    const std::vector<MeshTexel>& texels = placed.mesh->texels;
    const MeshTexel texel = number < texels.size() ? texels[number] : MeshTexel{};
    const auto& [position, normal] = vertex;
    CornerValues corner{within_skins(texel.u), within_skins(texel.v), {}, normal};
    if (placed.shading == Shading::Phong)
        corner.light =
            Fixed<std::int64_t, 16>::from_raw(std::int64_t{ambient_and_point_light(position, normal, light)} * 256);
    if (placed.shading == Shading::Gouraud) corner.light = rounded_shade(light_at(position, normal, light), light);
    return corner;
}

void MeshScratch::begin(std::size_t vertex_count) {
    if (world_vertices.size() < vertex_count) {
        world_vertices.resize(vertex_count);
        view_vertices.resize(vertex_count);
        values.resize(vertex_count);
    }
    stages.assign(vertex_count, VertexStage::Unknown);
}

bool any_in_view(const PlacedMesh& placed, MeshParts parts, const MeshTransform& transform, const ViewContext& view,
                 MeshScratch& scratch, const AskTriangle& asks) {
    const std::optional<MeshPlacement> mesh = place_mesh(placed, &transform, view, scratch);
    const auto any_of = [&](const MeshTriangle& triangle) { return any_of_triangle(triangle, *mesh, scratch, asks); };
    if (!mesh || !any_facing(*mesh, parts, scratch, any_of)) return false;
    scratch.begun = &placed;
    return true;
}

bool is_seen(const PlacedMesh& placed, MeshParts parts, const MeshTransform& transform, const ViewContext& view,
             const MeshTarget& target, MeshScratch& scratch) {
    MeshCounts counts;
    return any_in_view(placed, parts, transform, view, scratch,
                       [&](const auto& corners) { return find_triangle(corners, target, scratch.triangle, counts); });
}

MeshCounts draw_mesh(const PlacedMesh& placed, const MeshDrawing& drawing, const MeshTarget& target,
                     MeshScratch& scratch) {
    MeshCounts counts;
    const std::optional<MeshPlacement> placement = place_mesh(placed, drawing.transform, drawing.view, scratch);
    if (!placement) return counts;
    const Vec3<Unit> toward_eye = normalised(widening_difference(drawing.view.eye, placed.position));
    const MeshContext mesh{*placement,
                           target,
                           drawing,
                           highlights_of(placed, scratch),
                           halfway(drawing.light.directional.toward, toward_eye),
                           {"", 1, 1, {placed.colour}}};
    any_facing(mesh, drawing.parts, scratch, [&](const MeshTriangle& triangle) {
        draw_if_in_view(triangle, mesh, scratch, counts);
        ++counts.facing;
        return false;
    });
    return counts;
}

}  // namespace oblong

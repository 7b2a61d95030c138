#include "tools/gallery/mesh_scene.h"

#include "engine/view/views.h"

namespace oblong {

namespace {

ViewContext make_scene_view(const RowInput& input, int field_of_view) {
    Camera camera;
    camera.field_of_view = Degrees::from_int(field_of_view);
    return make_view_context(
        first_person_view(camera), input.mode,
        {.subpixel_bits = input.settings.accuracy.subpixel_bits, .corrects_aspect = input.settings.correct_aspect});
}

}  // namespace

MeshScene::MeshScene(const RowInput& input, Framebuffer canvas, int field_of_view)
    : colormap_(input.assets.colormap),
      view_(make_scene_view(input, field_of_view)),
      depth_(canvas.width_px, canvas.height_px),
      canvas_(canvas),
      scratch_(canvas.height_px) {
    depth_.want({0, canvas.width_px, 0, canvas.height_px});
    depth_.clear();
}

MeshCounts MeshScene::draw(const PlacedMesh& placed, const MeshLight& light, const Colormap* colormap) {
    const MeshDrawing drawing{view_, colormap ? *colormap : colormap_, light, nullptr, false};
    return draw_mesh(placed, drawing, {depth_, canvas_, {0, canvas_.width_px, 0, canvas_.height_px}}, scratch_);
}

std::uint8_t lit_colour(const GalleryAssets& assets, Rgb8 colour) {
    return nearest_colour(assets.colormap.palette, colour, kOrdinaryColours);
}

Colormap shade_numbers() {
    Colormap colormap;
    for (std::size_t shade = 0; shade < Colormap::kShades; ++shade)
        colormap.shades[shade].fill(static_cast<std::uint8_t>(shade));
    return colormap;
}

double exact_shade(double light) {
    return light < 128 ? 32 + (128 - light) * 31 / 128 : std::max(32 - (light - 128) * 32 / 128, 0.0);
}

std::optional<ExactHit> exact_hit(const PlacedMesh& placed, const RowInput& input, int field_of_view, double column,
                                  double row) {
    const double across = input.mode.width_px / 2.0 / std::tan(field_of_view * std::numbers::pi / 360);
    const double shape = input.settings.correct_aspect ? number_of(input.mode.pixel()) : 1;
    const Vec scale = vec_of(placed.scale);
    const auto corner = [&](std::uint32_t number) {
        const MeshVertex& vertex = placed.mesh->frames[0].vertices[number];
        const Vec n = vec_of(vertex.normal), p = vec_of(vertex.position);
        ExactCorner exact;
        exact.position = Vec{p.x * scale.x, p.y * scale.y, p.z * scale.z} + vec_of(placed.position);
        exact.normal = normalised(Vec{n.x / scale.x, n.y / scale.y, n.z / scale.z});
        exact.screen = {input.mode.width_px / 2.0 - across * exact.position.y / exact.position.x,
                        input.mode.height_px / 2.0 - across * shape * exact.position.z / exact.position.x};
        return exact;
    };
    const Vec at{column, row};
    std::optional<ExactHit> nearest;
    double nearest_depth = 1e30;
    for (const MeshTriangle& triangle : placed.mesh->triangles) {
        const std::array corners{corner(triangle.vertices[0]), corner(triangle.vertices[1]),
                                 corner(triangle.vertices[2])};
        const auto& [a, b, c] = corners;
        const double whole = cross(b.screen - a.screen, c.screen - a.screen).z;
        if (whole <= 0) continue;  // a back face
        const double of_b = cross(at - a.screen, c.screen - a.screen).z / whole,
                     of_c = cross(b.screen - a.screen, at - a.screen).z / whole;
        if (of_b < 0 || of_c < 0 || of_b + of_c > 1 || a.position.x > nearest_depth) continue;
        nearest_depth = a.position.x;
        nearest = ExactHit{corners,
                           {1 - of_b - of_c, of_b, of_c},
                           normalised(cross(c.position - a.position, b.position - a.position))};
    }
    return nearest;
}

namespace {

/// A mesh of one frame and one skin.
Mesh mesh_of(MeshFrame frame, Mesh mesh, Skin skin) {
    set_boxes(frame);
    mesh.frames.push_back(std::move(frame));
    mesh.skins.push_back(std::move(skin));
    return mesh;
}

}  // namespace

Skin checkered_skin(std::int32_t size, std::uint8_t one, std::uint8_t other) {
    Skin skin{"checkered", size, size, std::vector<std::uint8_t>(pixel_count(size, size))};
    for (std::int32_t v = 0; v < size; ++v)
        for (std::int32_t u = 0; u < size; ++u)
            item(skin.texels, v * size + u) = (u / 8 + v / 8) % 2 == 0 ? one : other;
    return skin;
}

Skin plain_skin(std::uint8_t colour) {
    return {"plain", 1, 1, {colour}};
}

Mesh ball_mesh(double radius, int rings, Skin skin) {
    Mesh mesh;
    const int around = 2 * rings;
    MeshFrame frame{"ball", {}, {}, {}};
    for (int ring = 0; ring <= rings; ++ring)
        for (int step = 0; step <= around; ++step) {
            const double down = std::numbers::pi * ring / rings, turn = 2 * std::numbers::pi * step / around;
            const Vec out{std::sin(down) * std::cos(turn), std::sin(down) * std::sin(turn), std::cos(down)};
            frame.vertices.push_back({world_point(out * radius), unit_vector(out)});
            mesh.texels.push_back({Texel::from_raw(std::int64_t{skin.width - 1} * 65536 * step / around),
                                   Texel::from_raw(std::int64_t{skin.height - 1} * 65536 * ring / rings)});
        }
    for (int ring = 0; ring < rings; ++ring)
        for (int step = 0; step < around; ++step) {
            const auto upper = static_cast<std::uint32_t>(ring * (around + 1) + step),
                       lower = upper + static_cast<std::uint32_t>(around) + 1;
            if (ring > 0) mesh.triangles.push_back({{upper, upper + 1, lower}, 0});
            if (ring < rings - 1) mesh.triangles.push_back({{upper + 1, lower + 1, lower}, 0});
        }
    return mesh_of(std::move(frame), std::move(mesh), std::move(skin));
}

Mesh cube_mesh(double half_size, Skin skin) {
    Mesh mesh;
    MeshFrame frame{"cube", {}, {}, {}};
    const double w = skin.width, h = skin.height;
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            const auto first = static_cast<std::uint32_t>(frame.vertices.size());
            for (const auto& [a, b] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}}) {
                Vec p, n;
                p[axis] = sign * half_size;
                n[axis] = sign;
                p[(axis + 1) % 3] = a * half_size;
                p[(axis + 2) % 3] = b * half_size;
                frame.vertices.push_back({world_point(p), unit_vector(n)});
                mesh.texels.push_back({Texel::from_raw(std::lround((a + 1) * w * 32768)),
                                       Texel::from_raw(std::lround((1 - b) * h * 32768))});
            }
            const std::uint32_t one = sign > 0 ? 2 : 1, other = 3 - one;
            mesh.triangles.push_back({{first, first + one, first + other}, 0});
            mesh.triangles.push_back({{first, first + one + 1, first + other + 1}, 0});
        }
    return mesh_of(std::move(frame), std::move(mesh), std::move(skin));
}

}  // namespace oblong

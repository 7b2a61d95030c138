#include "tools/gallery/staged_cube.h"

#include <algorithm>
#include <array>

#include "engine/methods/canonical_volume.h"
#include "engine/methods/mesh_stages.h"
#include "engine/methods/transforms.h"
#include "engine/raster/scan.h"
#include "engine/view/views.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

/// A cube of 2 units, with two triangles a side: corners are numbered by bits (x, y, z); sides run counter-clockwise
/// seen from outside, triangles clockwise.
Mesh make_cube() {
    Mesh cube;
    MeshFrame frame;
    for (int i = 0; i < 8; ++i)
        frame.vertices.push_back({world_point(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1), {}});
    constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {4, 5, 7, 6}, {0, 2, 3, 1}}};
    std::vector<std::array<std::uint32_t, 3>> corners;
    for (const auto& side : kSides) {
        cube.triangles.push_back({{side[0], side[2], side[1]}, 0});
        cube.triangles.push_back({{side[0], side[3], side[2]}, 0});
    }
    for (const MeshTriangle& triangle : cube.triangles) corners.push_back(triangle.vertices);
    set_normals(frame.vertices, corners);
    set_boxes(frame);
    cube.frames.push_back(frame);
    cube.texels.assign(8, {});
    return cube;
}

std::string outcode_letters(unsigned outcode) {
    constexpr std::array<char, 5> kLetters{'L', 'R', 'B', 'T', 'Z'};
    std::string text;
    for (std::size_t i = 0; i < kLetters.size(); ++i)
        if (outcode >> i & 1) text += kLetters[i];
    return text.empty() ? "-" : text;
}

template <class T>
std::string place_text(const Vec3<T>& p) {
    return triple_text(vec_of(p), "%5.2f");
}

std::string span_text(const ShownTriangle& triangle, Stage stage) {
    const Span &first = triangle.spans.front(), &last = triangle.spans.back(),
               &middle = triangle.spans[triangle.spans.size() / 2];
    if (stage == Stage::Scanned) return ": rows " + std::to_string(first.y) + " to " + std::to_string(last.y);
    if (stage == Stage::Spans)
        return ": " + std::to_string(middle.y) + ", " + std::to_string(middle.first) + "-" +
               std::to_string(middle.end - 1);
    std::int64_t pixels = 0;
    for (const Span& span : triangle.spans) pixels += span.end - span.first;
    return ": " + std::to_string(pixels) + " pixels";
}

/// The numbers after a stage of a triangle that faces the eye.
void add_lines_of(const ShownTriangle& triangle, Stage stage, const MeshLight& light, std::vector<std::string>& lines) {
    const std::string number = std::to_string(triangle.number);
    if (stage == Stage::Lit)
        lines.push_back(decimal_text(triangle.number, "%3.0f") +
                        decimal_text(dot(triangle.world_normal, light.directional.toward), " %8.3f") +
                        decimal_text(triangle.light, " %8.1f"));
    if (stage == Stage::Clipped) lines.push_back("triangle " + number + ": " + std::to_string(triangle.corners.size()));
    if (stage == Stage::Divided)
        for (const Vec3<Entry>& corner : triangle.divided) lines.push_back(triple_text(vec_of(corner), "%6.3f"));
    if (stage == Stage::Projected)
        for (const ScreenCorner& corner : triangle.corners)
            lines.push_back(decimals_text({corner.screen.x, corner.screen.y}, "%5.1f") +
                            decimal_text(1 / number_of(corner.inverse_z), " %6.2f"));
    if (stage >= Stage::Scanned && !triangle.spans.empty()) lines.push_back(number + span_text(triangle, stage));
}

constexpr std::array<const char*, 11> kCaptions{"  x     y     z",
                                                "  N . (eye - A)",
                                                "  x     y     z",
                                                "     N . L    light",
                                                "  x     y     z  out",
                                                "corners left",
                                                "  x      y      z",
                                                "column  row  depth",
                                                "first, last row",
                                                "middle row's span",
                                                "drawn"};

}  // namespace

StagedCube::StagedCube(const RowInput& input, Framebuffer part) : mesh(make_cube()), scratch(part.height_px) {
    placed.mesh = &mesh;
    placed.position = world_point(kCubeAhead, input.number(2) / 4, kCubeBelow);
    placed.yaw = input.angle(1);
    placed.colour = input.colour({230, 160, 70});
    placed.shading = Shading::Flat;
    view = make_view_context(look_at_view({}, world_point(2, 0, -1), Degrees::from_int(60)),
                             mode_of_part(input.mode, part));
    const MeshTransform transform = *make_mesh_transform(placed);
    const auto object = pose_of(placed, scratch.object_vertices);
    object_eye = to_object(view.eye, transform);
    light.ambient = 40;
    light.directional = {normalised(world_point(-2, -1, 2)), 110};
    find_facing(mesh.triangles, object, object_eye, scratch.facing);
    transform_to_world(object, transform, scratch.world_vertices);
    transform_to_view(object, placed, transform, view, scratch.view_vertices);
    find_corner_values(placed, scratch.world_vertices, {}, scratch.values);
    for (const std::uint32_t number : scratch.facing) {
        std::array<const ViewVertex*, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = &item(scratch.view_vertices, mesh.triangles[number].vertices[i]);
        ShownTriangle shown;
        shown.number = number;
        shown.world_normal = world_normal(mesh.triangles[number], object, transform);
        shown.light = light_at(placed.position, shown.world_normal, light) / 256.0;
        std::vector<Vec4> polygon_4;
        for (const std::uint32_t vertex : mesh.triangles[number].vertices) {
            const Vec3<World>& p = item(scratch.world_vertices, vertex).position;
            polygon_4.push_back(to_volume() * homogeneous(p));
        }
        for (const Vec4& corner : clip_to_volume(polygon_4)) shown.divided.push_back(*point_of(corner));
        const CornerValues none;
        clip_and_project(corners, {&none, &none, &none}, view, scratch.triangle.clip, shown.corners);
        std::vector<ScreenVertex> polygon;
        for (const ScreenCorner& corner : shown.corners) polygon.push_back(corner.screen);
        if (polygon.size() >= 3) {
            scan_convex(polygon, scratch.triangle.rows);
            append_spans(scratch.triangle.rows, {0, part.width_px, 0, part.height_px}, shown.spans);
        }
        triangles.push_back(std::move(shown));
    }
}

bool StagedCube::faces_eye(std::uint32_t triangle) const {
    return std::find(scratch.facing.begin(), scratch.facing.end(), triangle) != scratch.facing.end();
}

Matrix4 StagedCube::to_volume() const {
    return volume_matrix(view.projection, entry_of(kVolumeNear), entry_of(kVolumeFar)) *
           view_matrix(view.axes, view.eye);
}

std::vector<std::string> StagedCube::lines_of(Stage stage) const {
    std::vector<std::string> lines{item(kCaptions, stage)};
    const std::vector<MeshVertex>& object = mesh.frames[0].vertices;
    if (stage == Stage::Object)
        for (const MeshVertex& vertex : object) lines.push_back(place_text(vertex.position));
    for (std::uint32_t i = 0; stage == Stage::Facing && i < mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i].vertices;
        const auto normal =
            convert<World>(cross(object[c].position - object[a].position, object[b].position - object[a].position));
        lines.push_back(decimal_text(i, "%3.0f") +
                        decimal_text(dot(normal, object_eye - object[a].position), " %8.2f") +
                        (faces_eye(i) ? "  faces" : "  away"));
    }
    if (stage == Stage::InWorld)
        for (const WorldVertex& vertex : scratch.world_vertices) lines.push_back(place_text(vertex.position));
    if (stage == Stage::InView)
        for (const ViewVertex& vertex : scratch.view_vertices)
            lines.push_back(place_text(vertex.position) + " " + outcode_letters(vertex.outcode));
    for (const ShownTriangle& triangle : triangles) add_lines_of(triangle, stage, light, lines);
    return lines;
}

}  // namespace oblong

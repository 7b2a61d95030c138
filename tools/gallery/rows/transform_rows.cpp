// Transforms: model matrices (seed 3), rotations (2, 3, 5), the cube of seed 3.

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "engine/base/table.h"
#include "engine/fixed/trig.h"
#include "engine/math/matrix.h"
#include "engine/math/vec.h"
#include "engine/methods/polygons.h"
#include "engine/methods/transforms.h"
#include "tools/gallery/row.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

constexpr int kTextColumn_320 = 204;

/// The course notes' cube: eight corners, numbered from 1.
constexpr std::array<std::array<int, 3>, 8> kCubeCorners{
    {{-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}, {1, 1, 1}, {1, -1, 1}, {-1, 1, 1}, {-1, -1, 1}}};
/// Its twelve triangles. The eighth is listed as {8, 5, 1}.
constexpr std::array<std::array<int, 3>, 12> kCubeTriangles{{{1, 2, 3},
                                                             {1, 3, 4},
                                                             {4, 3, 5},
                                                             {4, 5, 6},
                                                             {6, 5, 7},
                                                             {6, 7, 8},
                                                             {8, 7, 2},
                                                             {8, 2, 1},
                                                             {2, 7, 5},
                                                             {2, 5, 3},
                                                             {6, 8, 1},
                                                             {6, 1, 4}}};
constexpr std::array<std::array<int, 2>, 12> kCubeEdges{
    {{1, 2}, {2, 3}, {3, 4}, {4, 1}, {8, 7}, {7, 5}, {5, 6}, {6, 8}, {1, 8}, {2, 7}, {3, 5}, {4, 6}}};

/// A corner in the world: the notes' axes are x right, y up, z ahead; the engine's x east, y north, z up.
Vec3<World> cube_corner(int number) {
    const auto& [x, y, z] = item(kCubeCorners, number - 1);
    return world_point(x, z, y);
}

const std::array kAxisEnds{world_point(4, 0, 0), world_point(0, 4, 0), world_point(0, 0, 3)};

void draw_cube(Sketch& sketch, const Matrix4& model, std::uint8_t colour) {
    for (const auto& [from, to] : kCubeEdges)
        sketch.line(transformed_point(model, cube_corner(from)), transformed_point(model, cube_corner(to)), colour);
}

Area fill_scene(const RowInput& input, Framebuffer canvas, std::int32_t width_of_320) {
    fill(canvas, input.assets.colour(18, 22, 34));
    return scene_area(canvas, width_of_320);
}

/// Scaled, then turned, then moved: shown after each step.
Figures draw_model_to_world(const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    const auto step = input.values[0];
    const Matrix3 turn = rotation_matrix(EulerAngles{input.angle(1), {}, {}});
    const Vec3<Entry> scale{entry_of(1.5), entry_of(0.5), entry_of(0.5)};
    const Vec3<World> position = step >= 2 ? world_point(2, 1.5, 0.5) : world_point(0, 0, 0);
    const Matrix4 model = model_matrix(position, step >= 1 ? turn : Matrix3::identity(), scale);

    Sketch sketch(input, canvas, fill_scene(input, canvas, 176), {world_point(5, -9, 6), world_point(1, 0.8, 0.3), 34});
    sketch.axes(kAxisEnds, assets);
    draw_cube(sketch, Matrix4::identity(), assets.colour(70, 78, 100));
    draw_cube(sketch, model, assets.colour(240, 190, 90));
    std::vector<std::string> lines{"model to world:"};
    for (const auto& row : model.rows) lines.push_back(row_text(row, "%5.2f"));
    draw_column(canvas, canvas.width_px * 178 / 320, kHeader_px + 8, lines, assets.text);

    const double angle = step >= 1 ? input.radians(1) : 0;
    const double x = 1.5 * std::cos(angle) - 0.5 * std::sin(angle) + (step >= 2 ? 2 : 0);
    const double y = 1.5 * std::sin(angle) + 0.5 * std::cos(angle) + (step >= 2 ? 1.5 : 0);
    const Vec3<World> corner = transformed_point(model, world_point(1, 1, 1));
    // Seed 5's normal (1, 1, 0) of a surface along (1, -1, 0), under a scale of (2, 1, 1).
    const Matrix3 stretch = linear_part(scaling({entry_of(2), entry_of(1), entry_of(1)}));
    const Vec3<Entry> normal = *normal_matrix(stretch) * Vec3<Entry>{entry_of(1), entry_of(1), {}};
    const Vec3<Entry> along = stretch * Vec3<Entry>{entry_of(1), entry_of(-1), {}};
    return {number_figure("x of the corner (1, 1, 1)", x, number_of(corner.x), 1e-3),
            number_figure("y of the corner (1, 1, 1)", y, number_of(corner.y), 1e-3),
            number_figure("stretched normal . surface, by the inverse transpose", 0,
                          number_of(normal.x) * number_of(along.x) + number_of(normal.y) * number_of(along.y), 1e-9),
            number_figure("x of that normal, of (1, 1, 0) under (2, 1, 1)", 0.5, number_of(normal.x), 1e-9)};
}

double largest_difference(const Matrix3& a, const Matrix3& b) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            most = std::max(most, std::abs(number_of(a.rows[i][j]) - number_of(b.rows[i][j])));
    return most;
}

/// One orientation by Euler angles, by a quaternion, and about an axis.
Figures draw_rotations(const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    const EulerAngles angles{input.angle(0), input.angle(1), input.angle(2)};
    const Quaternion quaternion = quaternion_of(angles);
    const Matrix3 by_angles = rotation_matrix(angles), by_quaternion = rotation_matrix(quaternion);
    // The axis is the quaternion's vector; the angle twice the arctangent of its length over w.
    const Vec3<Unit> axis = normalised(Vec3<Unit>{quaternion.x, quaternion.y, quaternion.z});
    const auto size = static_cast<std::int64_t>(length_of_raw({quaternion.x.raw, quaternion.y.raw, quaternion.z.raw}));
    const Angle half = arctangent2(size, quaternion.w.raw);
    const Matrix3 about_axis = rotation_matrix(axis, half + half);

    Sketch sketch(input, canvas, fill_scene(input, canvas, 200), {world_point(4, -6, 3.5), world_point(0, 0, 0), 40});
    sketch.axes(kAxisEnds, assets);
    draw_cube(sketch, homogeneous(by_quaternion), assets.colour(240, 190, 90));
    const auto end = [&](double reach) {
        return world_point(reach * number_of(axis.x), reach * number_of(axis.y), reach * number_of(axis.z));
    };
    sketch.line(end(-2.4), end(2.4), assets.colour(220, 120, 220));
    sketch.label(end(2.4), "axis", assets.colour(220, 120, 220));
    const std::vector<std::string> lines{"w " + decimal_text(number_of(quaternion.w), "%7.4f"),
                                         "x " + decimal_text(number_of(quaternion.x), "%7.4f"),
                                         "y " + decimal_text(number_of(quaternion.y), "%7.4f"),
                                         "z " + decimal_text(number_of(quaternion.z), "%7.4f"),
                                         "",
                                         "axis " + decimal_text(2 * half.bam * 180.0 / 32768, "%.2f") + " deg",
                                         decimal_text(number_of(axis.x), "%7.4f"),
                                         decimal_text(number_of(axis.y), "%7.4f"),
                                         decimal_text(number_of(axis.z), "%7.4f")};
    draw_column(canvas, canvas.width_px * kTextColumn_320 / 320, kHeader_px + 8, lines, assets.text);
    const double yaw = input.radians(0), pitch = input.radians(1);
    return {number_figure("quaternion - Euler angles", 0, largest_difference(by_angles, by_quaternion), 1e-7, 6),
            number_figure("axis - Euler angles", 0, largest_difference(by_angles, about_axis), 2e-4, 6),
            number_figure("x of the turned x axis: cos yaw cos pitch", std::cos(yaw) * std::cos(pitch),
                          number_of(by_quaternion.rows[0][0]), 1e-4, 6)};
}

/// The number of directed edges used once, and six times the signed volume.
struct CubeCheck {
    int matched_edges = 0;
    double volume = 0;
};
CubeCheck check_cube(const std::array<std::array<int, 3>, 12>& faces) {
    std::map<std::pair<int, int>, int> uses;
    CubeCheck check;
    for (const auto& face : faces) {
        std::array<Vec, 3> p;
        for (std::size_t i = 0; i < 3; ++i) {
            ++uses[{face[i], face[(i + 1) % 3]}];
            const auto& [x, y, z] = item(kCubeCorners, face[i] - 1);
            p[i] = Vec{double(x), double(y), double(z)};
        }
        check.volume += dot(p[0], cross(p[1], p[2])) / 6;
    }
    for (const auto& [edge, count] : uses)
        check.matched_edges += edge.first < edge.second && count == 1 && uses[{edge.second, edge.first}] == 1;
    return check;
}

Figures draw_left_handed_cube(const RowInput& input, Framebuffer canvas) {
    auto faces = kCubeTriangles;
    const bool is_listed = input.values[0] == 0;
    if (is_listed) faces[7] = {8, 5, 1};
    const double turn = input.radians(1);
    const Vec3<World> eye = world_point(-8 * std::cos(turn), -8 * std::sin(turn), 4);
    Sketch sketch(input, canvas, fill_scene(input, canvas, 320), {eye, world_point(0, 0, 0), 40});
    const std::array<std::uint8_t, 6> colours{input.colour(200, 80, 70),   input.colour(90, 170, 80),
                                              input.colour(90, 130, 220),  input.colour(220, 190, 90),
                                              input.colour(190, 110, 200), input.colour(90, 190, 190)};
    int drawn = 0;
    std::set<int> seen;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const std::array corners{cube_corner(faces[i][0]), cube_corner(faces[i][1]), cube_corner(faces[i][2])};
        // (B - A) x (C - A) points outward in left-handed axes; the engine's are right-handed.
        const Vec3<Unit> normal = normalised(cross(corners[2] - corners[0], corners[1] - corners[0]));
        if (faces_away(corners[0], normal, eye)) continue;
        ++drawn;
        seen.insert(faces[i].begin(), faces[i].end());
        sketch.polygon(corners, colours[i / 2]);
        sketch.outline(corners, input.colour(20, 20, 24));
    }
    for (const int number : seen)
        sketch.label(cube_corner(number), std::to_string(number), input.colour(235, 235, 225));
    const CubeCheck check = check_cube(faces);
    // Two for each side whose plane is between the eye and the cube; with the listed data, one may be missing or have
    // another direction.
    const int facing = 2 * ((std::abs(number_of(eye.x)) > 1) + (std::abs(number_of(eye.y)) > 1) + 1);
    return {count_figure("edges used once in each direction, of 18", is_listed ? 16 : 18, check.matched_edges),
            number_figure("signed volume", is_listed ? 22.0 / 3 : 8, check.volume, 1e-9),
            is_listed ? measured("triangles that face the eye", drawn)
                      : count_figure("triangles that face the eye", facing, drawn)};
}

}  // namespace

std::vector<Row> transform_rows() {
    return {
        {"model-to-world",
         draw_model_to_world,
         {choice_parameter("after", {"scale", "rotation", "translation"}, 2), {"yaw, degrees", 0, 345, 15, 30}}},
        {"rotations",
         draw_rotations,
         {{"yaw, degrees", 15, 345, 15, 30}, {"pitch, degrees", 0, 75, 15, 30}, {"roll, degrees", 0, 345, 15, 45}}},
        {"left-handed-cube",
         draw_left_handed_cube,
         {choice_parameter("eighth triangle", {"as listed", "corrected"}, 1), {"seen from, degrees", 0, 350, 10, 60}}}};
}

}  // namespace oblong

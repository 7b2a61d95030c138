// Transforms: model matrices (seed 3), rotations (2, 3, 5), the cube of seed 3.

#include <map>
#include <set>

#include "engine/methods/polygons.h"
#include "engine/methods/transforms.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

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
/// A corner in the world: the notes' axes are x right, y up, z ahead; the engine's x east, y north, z up.
Vec3<World> cube_corner(int number) {
    const auto& [x, y, z] = item(kCubeCorners, number - 1);
    return world_point(x, z, y);
}

const std::array<DrawnPoint, 3> kAxisEnds{{{4, 0, 0}, {0, 4, 0}, {0, 0, 3}}};

void draw_cube(Sketch& sketch, const Matrix4& model, Rgb8 colour) {
    const Cube cube{{-1, -1, -1}, 2};
    draw_edges(
        sketch, [&](int i) { return transformed_point(model, world_point(cube.corner(i))); }, colour);
}

/// Scaled, then turned, then moved: shown after each step.
Figures draw_model_to_world(const RowInput& input, Canvas& canvas) {
    const auto step = input.values[0];
    const Matrix3 turn = rotation_matrix(EulerAngles{input.angle(1), {}, {}});
    const Vec position = step >= 2 ? Vec{2, 1.5, 0.5} : Vec{};
    const Matrix4 model =
        model_matrix(world_point(position), step >= 1 ? turn : Matrix3::identity(), entries_of({1.5, 0.5, 0.5}));
    canvas.fill(kGround);
    Sketch sketch(canvas, canvas.scene(176), {{5, -9, 6}, {1, 0.8, 0.3}, 34});
    sketch.axes(kAxisEnds);
    draw_cube(sketch, Matrix4::identity(), kSteel);
    draw_cube(sketch, model, kOrange);
    canvas.column(canvas.width_px * 178 / 320, 8, matrix_lines("model to world:", model, "%5.2f", "%5.2f"));

    const double angle = step >= 1 ? input.radians(1) : 0;
    const Vec3<World> corner = transformed_point(model, world_point(1, 1, 1));
    // Seed 5's normal (1, 1, 0) of a surface along (1, -1, 0), under a scale of (2, 1, 1).
    const Matrix3 stretch = linear_part(scaling(entries_of({2, 1, 1})));
    const Vec normal = vec_of(*normal_matrix(stretch) * entries_of({1, 1})),
              along = vec_of(stretch * entries_of({1, -1}));
    return {{"x of the corner (1, 1, 1)", 1.5 * std::cos(angle) - 0.5 * std::sin(angle) + position.x, corner.x, 1e-3},
            {"y of the corner (1, 1, 1)", 1.5 * std::sin(angle) + 0.5 * std::cos(angle) + position.y, corner.y, 1e-3},
            {"stretched normal . surface, by the inverse transpose", 0, dot(normal, along), 1e-9},
            {"x of that normal, of (1, 1, 0) under (2, 1, 1)", 0.5, normal.x, 1e-9}};
}

/// One orientation by Euler angles, by a quaternion, and about an axis.
Figures draw_rotations(const RowInput& input, Canvas& canvas) {
    const EulerAngles angles{input.angle(0), input.angle(1), input.angle(2)};
    const Quaternion quaternion = quaternion_of(angles);
    const Matrix3 by_angles = rotation_matrix(angles), by_quaternion = rotation_matrix(quaternion);
    // The axis is the quaternion's vector; the angle twice the arctangent of its length over w.
    const Vec3<Unit> axis = normalised(Vec3<Unit>{quaternion.x, quaternion.y, quaternion.z});
    const auto size = static_cast<std::int64_t>(length_of_raw({quaternion.x.raw, quaternion.y.raw, quaternion.z.raw}));
    const Angle half = arctangent2(size, quaternion.w.raw);
    const Matrix3 about_axis = rotation_matrix(axis, half + half);

    canvas.fill(kGround);
    Sketch sketch(canvas, canvas.scene(200), {{4, -6, 3.5}, {0, 0, 0}, 40});
    sketch.axes(kAxisEnds);
    draw_cube(sketch, homogeneous(by_quaternion), kOrange);
    const Vec end = vec_of(axis) * 2.4;
    sketch.line(-end, end, kMauve);
    sketch.label(end, "axis", kMauve);
    std::vector<std::string> lines;
    const auto add = [&](const char* name, Unit part) { lines.push_back(name + decimal_text(part, "%7.4f")); };
    add("w ", quaternion.w);
    add("x ", quaternion.x);
    add("y ", quaternion.y);
    add("z ", quaternion.z);
    lines.insert(lines.end(), {"", "axis " + decimal_text(2 * half.bam * 180.0 / 32768, "%.2f") + " deg"});
    for (const Unit part : {axis.x, axis.y, axis.z}) add("", part);
    canvas.column(canvas.width_px * 204 / 320, 8, lines);
    return {{"quaternion - Euler angles", 0, largest_difference(by_angles, by_quaternion), 1e-7, 6},
            {"axis - Euler angles", 0, largest_difference(by_angles, about_axis), 2e-4, 6},
            {"x of the turned x axis: cos yaw cos pitch", std::cos(input.radians(0)) * std::cos(input.radians(1)),
             by_quaternion.rows[0][0], 1e-4, 6}};
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

Figures draw_left_handed_cube(const RowInput& input, Canvas& canvas) {
    auto faces = kCubeTriangles;
    const bool is_listed = input.values[0] == 0;
    if (is_listed) faces[7] = {8, 5, 1};
    const double turn = input.radians(1);
    const Vec3<World> eye = world_point(-8 * std::cos(turn), -8 * std::sin(turn), 4);
    canvas.fill(kGround);
    Sketch sketch(canvas, canvas.scene(), {vec_of(eye), {0, 0, 0}, 40});
    constexpr std::array kColours{kScarlet, kLeaf, kBlue, kOrange, kMauve, Rgb8{90, 190, 190}};
    int drawn = 0;
    std::set<int> seen;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const std::array corners{cube_corner(faces[i][0]), cube_corner(faces[i][1]), cube_corner(faces[i][2])};
        // (B - A) x (C - A) points outward in left-handed axes; the engine's are right-handed.
        const Vec3<Unit> normal = normalised(cross(corners[2] - corners[0], corners[1] - corners[0]));
        if (faces_away(corners[0], normal, eye)) continue;
        ++drawn;
        seen.insert(faces[i].begin(), faces[i].end());
        sketch.polygon(corners, kColours[i / 2]);
        sketch.outline(corners, kNight);
    }
    for (const int number : seen) sketch.label(cube_corner(number), std::to_string(number), kWhite);
    const CubeCheck check = check_cube(faces);
    // Two for each side whose plane is between the eye and the cube; with the listed data, one may be missing or have
    // another direction.
    const int facing = 2 * ((std::abs(number_of(eye.x)) > 1) + (std::abs(number_of(eye.y)) > 1) + 1);
    return {{"edges used once in each direction, of 18", is_listed ? 16 : 18, check.matched_edges},
            {"signed volume", is_listed ? 22.0 / 3 : 8, check.volume, 1e-9},
            is_listed ? Figure{"triangles that face the eye", drawn}
                      : Figure{"triangles that face the eye", facing, drawn}};
}

}  // namespace

std::vector<Row> transform_rows() {
    return {{"model-to-world",
             draw_model_to_world,
             {{"after", {"scale", "rotation", "translation"}, 2}, {"yaw, degrees", 0, 345, 15, 30}}},
            {"rotations",
             draw_rotations,
             {{"yaw, degrees", 15, 345, 15, 30}, {"pitch, degrees", 0, 75, 15, 30}, {"roll, degrees", 0, 345, 15, 45}}},
            {"left-handed-cube",
             draw_left_handed_cube,
             {{"eighth triangle", {"as listed", "corrected"}, 1}, {"seen from, degrees", 0, 350, 10, 60}}}};
}

}  // namespace oblong

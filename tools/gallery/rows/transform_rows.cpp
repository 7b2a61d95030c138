// Transforms: model matrices (seed 3), rotations (2, 3, 5). Back faces: the cube of seed 3; by a dot product, and why
// normals alone mislead (5).

#include <cmath>
#include <map>
#include <set>

#include "engine/methods/polygons.h"
#include "engine/methods/transforms.h"
#include "engine/raster/scan.h"
#include "engine/view/project.h"
#include "tools/gallery/counted.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

/// The course notes' cube: eight corners, numbered from 1.
constexpr std::array<std::array<int, 3>, 8> kCubeCorners{
    {{-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}, {1, 1, 1}, {1, -1, 1}, {-1, 1, 1}, {-1, -1, 1}}};
/// Its twelve triangles. The eighth is listed as {8, 5, 1}.
using Triple = std::array<int, 3>;
constexpr std::array kCubeTriangles{Triple{1, 2, 3}, Triple{1, 3, 4}, Triple{4, 3, 5}, Triple{4, 5, 6},
                                    Triple{6, 5, 7}, Triple{6, 7, 8}, Triple{8, 7, 2}, Triple{8, 2, 1},
                                    Triple{2, 7, 5}, Triple{2, 5, 3}, Triple{6, 8, 1}, Triple{6, 1, 4}};
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
    Sketch sketch(canvas, canvas.scene(176), {{5, -9, 6}, {1, 0.8, 0.3}, 34});
    sketch.axes(kAxisEnds);
    draw_cube(sketch, Matrix4::identity(), kSteel);
    draw_cube(sketch, model, kOrange);
    canvas.column(canvas.width_px * 178 / 320, 8, matrix_lines("model to world:", model, "%5.2f"));

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
CubeCheck check_cube(const std::array<Triple, 12>& faces) {
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

/// Quadrilaterals on a sphere, their corners clockwise seen from outside.
struct BallFace {
    std::array<Vec3<World>, 4> corners;
    Vec3<Unit> normal;
};

std::vector<BallFace> make_ball(const Vec& middle, double radius) {
    constexpr int kAcross = 16, kUp = 8;
    const auto at = [&](int column, int row) {
        const double a = column * 2 * std::numbers::pi / kAcross, b = (row - kUp / 2) * std::numbers::pi / kUp;
        return world_point(middle + Vec{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)} * radius);
    };
    std::vector<BallFace> faces;
    for (int row = 0; row < kUp; ++row)
        for (int column = 0; column < kAcross; ++column) {
            const std::array corners{at(column, row), at(column, row + 1), at(column + 1, row + 1),
                                     at(column + 1, row)};
            // From the diagonals, since two corners coincide at the poles.
            faces.push_back({corners, normalised(cross(corners[3] - corners[1], corners[2] - corners[0]))});
        }
    return faces;
}

/// The rule for drawing a face.
enum class CullRule { ObjectDot, ViewNormal, ScreenArea };

using ScreenCorners = std::array<ScreenVertex, 4>;

/// The faces are all in front of the eye.
ScreenCorners screen_corners(const BallFace& face, const ViewContext& view) {
    ScreenCorners screen;
    for (std::size_t i = 0; i < 4; ++i) {
        const ScreenPosition p = project(to_view(face.corners[i], view), view.projection);
        screen[i] = {convert<Screen>(p.x), convert<Screen>(p.y)};
    }
    return screen;
}

/// Whether the sign of a face's area may come from the rounding of its corners: each of the two diagonals counts twice.
bool may_be_of_either_sign(const BallFace& face, const ViewContext& view) {
    const ScreenCorners at = screen_corners(face, view);
    const double rounding_px = std::ldexp(0.5, -Screen::kFractionBits);
    const auto length = [](Screen from, Screen to) { return std::abs(number_of(to) - number_of(from)); };
    const double diagonals =
        length(at[0].x, at[2].x) + length(at[0].y, at[2].y) + length(at[1].x, at[3].x) + length(at[1].y, at[3].y);
    return std::abs(number_of(doubled_area(at))) <= 2 * rounding_px * diagonals;
}

bool is_drawn(const BallFace& face, CullRule rule, const ViewContext& view) {
    if (rule == CullRule::ObjectDot) return !faces_away(face.corners[1], face.normal, view.eye);
    if (rule == CullRule::ViewNormal) return !normal_points_away(face.normal, view.axes.forward);
    return doubled_area(screen_corners(face, view)) > ScreenArea{};
}

/// Whether a face faces the eye, in double precision.
bool faces_eye_in_double(const BallFace& face, const Vec3<World>& eye) {
    const auto& [a, b, c, d] = face.corners;
    return dot(cross(vec_of(d - b), vec_of(c - a)), vec_of(b - eye)) < 0;
}

Figures draw_culling(const RowInput& input, Canvas& canvas) {
    const Vec3<World> eye;
    Sketch sketch(canvas, canvas.scene(), {vec_of(eye), {100, 0, 0}, static_cast<int>(input.values[1])});
    int faces = 0;
    std::array<int, 3> wrong{};  // by rule
    for (int column = -2; column <= 2; ++column)
        for (int row = -1; row <= 1; ++row)
            for (const BallFace& face : make_ball({60, column * 26.0, row * 26.0}, 11)) {
                const bool faces_eye = faces_eye_in_double(face, eye);
                ++faces;
                for (const auto by : {CullRule::ObjectDot, CullRule::ViewNormal, CullRule::ScreenArea})
                    wrong[static_cast<std::size_t>(by)] +=
                        is_drawn(face, by, sketch.view()) != faces_eye &&
                        !(by == CullRule::ScreenArea && may_be_of_either_sign(face, sketch.view()));
                const bool draws = is_drawn(face, static_cast<CullRule>(input.values[0]), sketch.view());
                if (faces_eye) sketch.polygon(face.corners, draws ? kGrey : Rgb8{240, 200, 60});
                if (faces_eye || draws) sketch.outline(face.corners, faces_eye ? kSlate : kScarlet);
            }
    const Vec3<Counted<double>> u{1, 2, 3}, v{4, -5, 6};
    const CountedOperations whole = operations_of([&] { cross_by_components(u, v); }),
                            third = operations_of([&] { cross_z(u, v); });
    canvas.note(std::array{"cross product  " + whole.text(), "z of it alone  " + third.text()});
    // Errata A9: (10, 0, 10), (11, 0, 12), (10, 1, 10) in viewspace has the normal (-2, 0, 1) and faces the eye.
    const Vec3<World> a = world_point(10, 0, 10), b = world_point(11, 0, 12), c = world_point(10, 1, 10);
    const Vec normal = vec_of(cross(b - a, c - a));
    return {{"wrong by normal . (vertex - eye), in object space", 0, wrong[0]},
            {"wrong by the normal's z in viewspace", std::to_string(wrong[1]) + " of " + std::to_string(faces)},
            {"wrong by the sign of an area on the screen, beyond rounding", 0, wrong[2]},
            {"z of a cross product of edges: a third of 6 * 0 / 3 +", "2 * 0 / 1 +", third.text(),
             third == CountedOperations{2, 0, 1} && whole == CountedOperations{6, 0, 3}},
            {"normal . vertex of the seed's triangle, below 0: faces the eye", -10, dot(vec_of(a), normal), 1e-9},
            {"its normal's z, above 0: points away", 1, normal.z, 1e-9}};
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
             {{"eighth triangle", {"as listed", "corrected"}, 1}, {"seen from, degrees", 0, 350, 10, 60}}},
            {"culling",
             draw_culling,
             {{"drawn by",
               {"dot product in object space", "normal's z in viewspace", "z of a cross product on the screen"},
               1},
              {"field of view, degrees", 30, 110, 10, 90}}}};
}

}  // namespace oblong

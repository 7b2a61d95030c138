// Seeds 3 and 5: a model in the pipeline, and among the surfaces of a level; shading, and light as dot products; the
// effect of scaling on normals.

#include "engine/frame/frame_counts.h"
#include "tools/gallery/mesh_scene.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

MeshLight light_from_above() {
    return {50, {unit_vector({-1, -1, 2}), 90}, {}, 100};
}

constexpr double kHalfCube = 30;
constexpr int kPitchDegrees = 25;

/// The number of sides of a turned cube that face the eye, which is `distance` from its middle.
std::int64_t sides_in_front(double distance, double yaw, double pitch) {
    // The x components of its axes: ahead, left, up.
    const std::array towards{std::cos(pitch) * std::cos(yaw), -std::sin(yaw), std::sin(pitch) * std::cos(yaw)};
    return std::count_if(towards.begin(), towards.end(),
                         [distance](double x) { return distance * std::abs(x) > kHalfCube; });
}

Figures draw_cube(const RowInput& input, Canvas& canvas) {
    const Mesh cube = cube_mesh(kHalfCube, checkered_skin(64, lit_colour(input.assets, {190, 150, 90}),
                                                          lit_colour(input.assets, {120, 60, 40})));
    PlacedMesh placed = placed_mesh(cube, {input.number(1), 0}, Shading::Flat);
    placed.yaw = input.angle(0);
    placed.pitch = degrees_to_angle(Degrees::from_int(-kPitchDegrees));
    const SidePicture covered(canvas.width_px, canvas.height_px, 255);
    MeshScene(input, canvas).draw(placed, light_from_above());
    const Colormap numbers = shade_numbers();
    const MeshCounts counts = MeshScene(input, covered).draw(placed, light_from_above(), &numbers);
    const std::vector<std::uint8_t> none(covered.indices.size(), 255);
    return {{"triangles that face the eye, of 12",
             2 * sides_in_front(input.number(1), input.radians(0), -kPitchDegrees * kDegree), counts.facing},
            {"pixels drawn: each once", count_differences(covered.indices, none), counts.pixels},
            {"triangles with pixels, after clipping to the view", counts.triangles}};
}

Figures draw_in_level(const RowInput& input, Canvas& canvas) {
    const Mesh ball = ball_mesh(
        30, 16, checkered_skin(64, lit_colour(input.assets, {200, 190, 170}), lit_colour(input.assets, {60, 80, 130})));
    PlacedMesh placed = placed_mesh(ball, {input.number(0), 420, 60}, static_cast<Shading>(input.values[1]));
    placed.highlight = 60;
    placed.yaw = Angle::from_bam(input.time_ms * 8);
    DemoFrame frame(input, input.mode);
    FrameCounts counts;
    frame.work.observers.counts = &counts;
    const auto drawn_with_depth = [&](Framebuffer picture) {
        frame.draw(camera_at(0, 120, 70, 90, 0, 70), picture);
        std::int64_t pixels = 0;
        for (const ScreenRectangle& part : frame.work.view.depth.rectangles())
            pixels += std::int64_t{part.end_column - part.first_column} * (part.end_row - part.first_row);
        return pixels;
    };
    const std::int64_t before = drawn_with_depth(SidePicture(canvas.width_px, canvas.height_px));
    frame.scene.meshes = {&placed, 1};
    const std::int64_t after = drawn_with_depth(canvas);
    return {{"pixels with depth in a frame without it", 0, before},
            {"pixels with depth: the rectangle around it", after},
            {"pixels that it owns", counts.of(Effect::Meshes)}};
}

constexpr int kBallsFieldOfView = 50;
constexpr double kBallsDistance = 200;
constexpr std::array kShadings{Shading::Flat, Shading::Gouraud, Shading::Phong};
constexpr std::array kShadingNames{"flat", "Gouraud", "Phong"};

/// The direction to a light that circles an object on the eye's side: 0 is right, 90 above.
Vec toward_light(double angle) {
    return normalised(Vec{-0.8, -std::cos(angle), std::sin(angle)});
}

/// A point's pixel.
Vec mark_at(const MeshScene& scene, const Vec3<World>& position) {
    const ViewContext& view = scene.view();
    const ScreenPosition place = project(to_view(position, view.eye, view.axes), view.projection);
    return {std::floor(number_of(place.x)), std::floor(number_of(place.y))};
}

void draw_mark(Canvas& canvas, const Vec& mark) {
    for (const int step : {-3, -2, 2, 3}) {
        canvas.line(mark + Vec{step * 1.0, 0}, mark + Vec{step * 1.0, 0}, kBright);
        canvas.line(mark + Vec{0, step * 1.0}, mark + Vec{0, step * 1.0}, kBright);
    }
}

/// The positions of the row's balls.
constexpr double kBallRadius = 27, kBallStep = 60, kBallHeight = 8;

/// The light of Phong's reflection: ambient, diffuse and a highlight around the direction halfway between light and
/// eye.
double reflected(const Vec& normal, const Vec& toward, const Vec& eye, double highlight) {
    const Vec half = normalised(toward + eye);
    return 24 + 110 * std::max(dot(normal, toward), 0.0) +
           highlight * std::pow(std::max(dot(normal, half), 0.0), kShininess);
}

/// The expected shade of the mark, from the corners of the triangle there.
double expected_shade(std::size_t kind, const PlacedMesh& placed, const ExactHit& hit, const Vec& toward) {
    const Vec eye = normalised(vec_of(placed.position) * -1);
    if (kShadings[kind] == Shading::Flat) return exact_shade(reflected(hit.normal, toward, eye, 0));
    double shade = 0;
    Vec normal;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec& corner = hit.corners[i].normal;
        shade += hit.shares[i] * exact_shade(reflected(corner, toward, eye, 0));
        normal = normal + corner * hit.shares[i];
    }
    if (kShadings[kind] == Shading::Gouraud) return shade;
    return exact_shade(reflected(normalised(normal), toward, eye, placed.highlight));
}

Figures draw_shadings(const RowInput& input, Canvas& canvas) {
    const Mesh ball =
        ball_mesh(kBallRadius, static_cast<int>(input.values[0]), plain_skin(lit_colour(input.assets, {150, 90, 40})));
    const Vec toward = toward_light(input.radians(1));
    const MeshLight light{24, {unit_vector(toward), 110}, {}, 100};
    const SidePicture numbers(canvas.width_px, canvas.height_px);
    MeshScene scene(input, canvas, kBallsFieldOfView), numbered(input, numbers, kBallsFieldOfView);
    const Colormap by_number = shade_numbers();
    const bool has_rounded_corners = input.settings.accuracy.subpixel_bits < Screen::kFractionBits;
    Figures figures;
    for (std::size_t kind = 0; kind < kShadings.size(); ++kind) {
        const Vec middle{kBallsDistance, kBallStep * (1 - static_cast<double>(kind)), kBallHeight};
        PlacedMesh placed = placed_mesh(ball, middle, kShadings[kind]);
        placed.highlight = 90;
        scene.draw(placed, light);
        numbered.draw(placed, light, &by_number);
        const Vec mark = mark_at(scene, placed.position + world_point(-25, -3, 7));
        const auto hit = exact_hit(placed, input, kBallsFieldOfView, mark.x + 0.5, mark.y + 0.5);
        const std::string name = std::string("shade at the mark, ") + kShadingNames[kind];
        const double expected = hit ? expected_shade(kind, placed, *hit, toward) : -1;
        figures.push_back(has_rounded_corners ? Figure{name, decimal_text(numbers.at(mark), "%.1f")}
                                              : Figure{name, expected, numbers.at(mark), 1.6, 1});
        draw_mark(canvas, mark);
        canvas.label(mark_at(scene, placed.position + world_point(0, 0, -kBallRadius - 6)), kShadingNames[kind],
                     kBright, -text_width_px(kShadingNames[kind]) / 2, 0);
    }
    return figures;
}

enum class Kind : std::uint8_t { Ambient, Directional, Point };
constexpr double kLitRadius = 46;

/// The expected light at a point of the ball.
double expected_light(Kind kind, const Vec& normal, const Vec& position, const Vec& lamp) {
    if (kind == Kind::Ambient) return 90;
    const Vec way = kind == Kind::Point ? lamp - position : lamp;
    const double distance = kind == Kind::Point ? std::sqrt(dot(way, way)) : 0;
    return std::max(dot(normal, normalised(way)), 0.0) *
           (kind == Kind::Point ? std::max(150 - distance, 0.0) * 1.5 : 120);
}

Figures draw_lights(const RowInput& input, Canvas& canvas) {
    const auto kind = static_cast<Kind>(input.values[0]);
    const Vec toward = toward_light(input.radians(1)), middle{kBallsDistance, 0, 8};
    const Mesh ball = ball_mesh(kLitRadius, 24, plain_skin(lit_colour(input.assets, {130, 130, 140})));
    const PlacedMesh placed = placed_mesh(ball, middle, Shading::Gouraud);
    const Vec lamp = kind == Kind::Point ? middle + toward * 90 : toward;
    const MovingLight point{world_point(lamp), World::from_int(150), 384};
    MeshLight light{
        kind == Kind::Ambient ? 90 : 0, {unit_vector(toward), kind == Kind::Directional ? 120 : 0}, {}, 100};
    if (kind == Kind::Point) light.points = {&point, 1};
    MeshScene scene(input, canvas, kBallsFieldOfView);
    scene.draw(placed, light);

    Figures figures;
    constexpr std::array kPlaces{Vec{-0.5, -0.5, 0.7}, Vec{-0.8, 0.6, 0.2}, Vec{-0.6, -0.2, -0.78}};
    for (std::size_t i = 0; i < kPlaces.size(); ++i) {
        const Vec normal = normalised(kPlaces[i]), position = middle + normal * kLitRadius;
        const double found = light_at(world_point(position), unit_vector(normal), light) / 256.0;
        const std::string name(1, static_cast<char>('A' + i)), label = name + " " + decimal_text(found, "%.1f");
        figures.push_back({"light at " + name, expected_light(kind, normal, position, lamp), found, 0.05, 2});
        const Vec mark = mark_at(scene, world_point(position));
        draw_mark(canvas, mark);
        canvas.label(mark, label, kBright, normal.y > 0 ? -8 - text_width_px(label) : 6);
    }
    if (kind == Kind::Point) {
        const Vec mark = mark_at(scene, point.position);
        canvas.box({static_cast<std::int32_t>(mark.x) - 2, static_cast<std::int32_t>(mark.y) - 2, 5, 5},
                   {255, 240, 150});
        canvas.label(mark, "lamp", kBright, 6);
    }
    return figures;
}

/// The angle between two directions of the plane, degrees.
double degrees_between(const Vec& a, const Vec& b) {
    return std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y)) * 180 / std::numbers::pi;
}

/// Seed 5 claims that scaling keeps normals normal; its erratum A7 shows that it does not. The cross product of two
/// edges, its other way to a normal, is always right.
Figures draw_normals(const RowInput& input, Canvas& canvas) {
    const double scale = input.number(0) / 4;
    Diagram diagram(canvas, {0, 0}, 4.4);
    Matrix3 matrix = Matrix3::identity();
    matrix.rows[0][0] = Entry::from_raw(input.values[0] * (std::int64_t{1} << 30));
    const std::optional<Matrix3> normals = normal_matrix(matrix);
    if (!normals) return {};
    diagram.ellipse({}, {scale, 0}, {0, 1}, 96, kPale);
    double worst_normal = 0, worst_point = 0, expected_point = 0;
    for (int step = 0; step < 12; ++step) {
        const double angle = (step + 0.5) * std::numbers::pi / 6, c = std::cos(angle), s = std::sin(angle);
        const Vec3<Entry> normal = entries_of({c, s}), along{-normal.y, normal.x, {}};
        const Vec from{scale * c, s}, as_point = vec_of(matrix * normal), as_normal = vec_of(*normals * normal),
                                      of_edges = vec_of(cross(convert<World>(matrix * along), world_point(0, 0, 1)));
        const auto arrow = [&](const Vec& way, double length, Rgb8 colour) {
            diagram.arrow(from, from + way * (length / std::hypot(way.x, way.y)), colour);
        };
        arrow(as_point, 0.6, kRed);
        arrow(as_normal, 0.6, kGreen);
        arrow(of_edges, 0.35, kLemon);
        worst_normal = std::max(worst_normal, degrees_between(as_normal, of_edges));
        worst_point = std::max(worst_point, degrees_between(as_point, of_edges));
        expected_point = std::max(expected_point, degrees_between({scale * c, s}, {c, scale * s}));
    }
    diagram.label({-0.9, 0.5}, "N = M n", kRed);
    diagram.label({-0.9, 0.15}, "N = M^-T n", kGreen);
    diagram.label({-0.9, -0.2}, "N = M e0 x M e1", kLemon);
    const Vec tangent = vec_of(matrix * entries_of({1, -1}));
    return {{"degrees from M^-T n to M e0 x M e1, worst", 0, worst_normal, 0.05},
            {"degrees from M n to M e0 x M e1, worst", expected_point, worst_point, 0.05},
            {"M n . M t of n (1, 1, 0), t (1, -1, 0)", scale * scale - 1,
             dot(vec_of(matrix * entries_of({1, 1})), tangent), 1e-9, 4},
            {"M^-T n . M t", 0, dot(vec_of(*normals * entries_of({1, 1})), tangent), 1e-6, 4}};
}

}  // namespace

std::vector<Row> shading_rows() {
    return {{"mesh-pipeline", draw_cube, {{"turn, degrees", 0, 355, 5, 30}, {"distance", 32, 400, 8, 160}}},
            {"mesh-in-level", draw_in_level, {{"x", -200, 200, 10, -70}, {"shading", {"flat", "Gouraud", "Phong"}, 1}}},
            {"shading", draw_shadings, {{"rings of the ball", 4, 24, 1, 7}, {"light from, degrees", 0, 345, 15, 60}}},
            {"lights",
             draw_lights,
             {{"light", {"ambient", "directional", "point"}, 1}, {"light from, degrees", 0, 345, 15, 60}}},
            {"normals", draw_normals, {{"scale of x, quarters", 1, 12, 1, 8}}}};
}

}  // namespace oblong

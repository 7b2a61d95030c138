// Seeds 3 and 5: shading, and light as dot products. The effect of scaling on normals.

#include <array>
#include <cmath>
#include <numbers>

#include "engine/base/table.h"
#include "engine/draw/drawing.h"
#include "tools/gallery/diagram.h"
#include "tools/gallery/mesh_scene.h"
#include "tools/gallery/row.h"

namespace oblong {

namespace {

constexpr int kBallsFieldOfView = 50;
constexpr double kBallsDistance = 200;
constexpr std::array kShadings{Shading::Flat, Shading::Gouraud, Shading::Phong};
constexpr std::array kShadingNames{"flat", "Gouraud", "Phong"};

/// The direction to a light that circles an object on the eye's side: 0 is right, 90 above.
Vec toward_light(double angle) {
    return normalised(Vec{-0.8, -std::cos(angle), std::sin(angle)});
}

Vec3<Unit> unit_of(const Vec& direction) {
    return unit_vector(direction.x, direction.y, direction.z);
}

/// A marked pixel of the canvas.
struct Mark {
    std::int32_t column = 0, row = 0;
};

Mark mark_at(const MeshScene& scene, const Vec3<World>& position) {
    const ViewContext& view = scene.view();
    const ScreenPosition place = project(to_view(position, view.eye, view.axes), view.projection);
    return {static_cast<std::int32_t>(floor_of(place.x)), static_cast<std::int32_t>(floor_of(place.y))};
}

void draw_mark(Framebuffer canvas, Mark mark, std::uint8_t colour) {
    for (const int step : {-3, -2, 2, 3}) {
        set_pixel(canvas, mark.column + step, mark.row, colour);
        set_pixel(canvas, mark.column, mark.row + step, colour);
    }
}

/// The positions of the row's balls.
constexpr double kBallRadius = 27, kBallStep = 60, kBallHeight = 8;

PlacedMesh shaded_ball(const Mesh& mesh, std::size_t kind) {
    PlacedMesh placed;
    placed.mesh = &mesh;
    placed.position = world_point(kBallsDistance, kBallStep * (1 - static_cast<double>(kind)), kBallHeight);
    placed.shading = kShadings[kind];
    placed.highlight = 90;
    return placed;
}

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

Figures draw_shadings(const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    fill(canvas, assets.colour(20, 24, 36));
    const Mesh ball =
        ball_mesh(kBallRadius, static_cast<int>(input.values[0]), plain_skin(lit_colour(assets, 150, 90, 40)));
    const Vec toward = toward_light(input.radians(1));
    const MeshLight light{24, {unit_of(toward), 110}, {}, 100};
    MeshScene scene(input, canvas, kBallsFieldOfView);
    std::vector<std::uint8_t> numbers(pixel_count(canvas.width_px, canvas.height_px));
    MeshScene numbered(input, {numbers.data(), canvas.width_px, canvas.height_px, canvas.width_px}, kBallsFieldOfView);
    const Colormap by_number = shade_numbers();
    const bool has_rounded_corners = input.settings.accuracy.subpixel_bits < Screen::kFractionBits;
    Figures figures;
    for (std::size_t kind = 0; kind < kShadings.size(); ++kind) {
        const PlacedMesh placed = shaded_ball(ball, kind);
        scene.draw(placed, light);
        numbered.draw(placed, light, &by_number);
        const Mark mark = mark_at(scene, placed.position + world_point(-25, -3, 7));
        const auto hit = exact_hit(placed, input, kBallsFieldOfView, mark.column + 0.5, mark.row + 0.5);
        const double found = item(numbers, mark.row * canvas.width_px + mark.column);
        const std::string name = std::string("shade at the mark, ") + kShadingNames[kind];
        const double expected = hit ? expected_shade(kind, placed, *hit, toward) : -1;
        figures.push_back(has_rounded_corners ? measured(name, decimal_text(found, "%.1f"))
                                              : number_figure(name, expected, found, 1.6, 1));
        draw_mark(canvas, mark, assets.colour(255, 255, 255));
        const Mark label = mark_at(scene, placed.position + world_point(0, 0, -kBallRadius - 6));
        draw_text(canvas, label.column - text_width_px(kShadingNames[kind]) / 2, label.row, kShadingNames[kind],
                  assets.text);
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

Figures draw_lights(const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    fill(canvas, assets.colour(20, 24, 36));
    const auto kind = static_cast<Kind>(input.values[0]);
    const Vec toward = toward_light(input.radians(1));
    const Mesh ball = ball_mesh(kLitRadius, 24, plain_skin(lit_colour(assets, 130, 130, 140)));
    PlacedMesh placed;
    placed.mesh = &ball;
    placed.shading = Shading::Gouraud;
    placed.position = world_point(kBallsDistance, 0, 8);
    const Vec lamp =
        kind == Kind::Point ? Vec{kBallsDistance + toward.x * 90, toward.y * 90, 8 + toward.z * 90} : toward;
    const MovingLight point{world_point(lamp.x, lamp.y, lamp.z), World::from_int(150), 384};
    MeshLight light{kind == Kind::Ambient ? 90 : 0, {unit_of(toward), kind == Kind::Directional ? 120 : 0}, {}, 100};
    if (kind == Kind::Point) light.points = {&point, 1};
    MeshScene scene(input, canvas, kBallsFieldOfView);
    scene.draw(placed, light);

    Figures figures;
    constexpr std::array kPlaces{Vec{-0.5, -0.5, 0.7}, Vec{-0.8, 0.6, 0.2}, Vec{-0.6, -0.2, -0.78}};
    for (std::size_t i = 0; i < kPlaces.size(); ++i) {
        const Vec normal = normalised(kPlaces[i]);
        const Vec position{kBallsDistance + normal.x * kLitRadius, normal.y * kLitRadius, 8 + normal.z * kLitRadius};
        const Vec3<World> on_ball = world_point(position.x, position.y, position.z);
        const double found = light_at(on_ball, unit_of(normal), light) / 256.0;
        const double expected = expected_light(kind, normal, position, lamp);
        const std::string name(1, static_cast<char>('A' + i));
        figures.push_back(number_figure("light at " + name, expected, found, 0.05, 2));
        const Mark mark = mark_at(scene, on_ball);
        draw_mark(canvas, mark, assets.colour(255, 255, 255));
        const bool is_left = normal.y > 0;
        const std::string label = name + " " + decimal_text(found, "%.1f");
        draw_text(canvas, is_left ? mark.column - 8 - text_width_px(label) : mark.column + 6, mark.row - 4, label,
                  assets.text);
    }
    if (kind == Kind::Point) {
        const Mark mark = mark_at(scene, point.position);
        fill_area(canvas, {mark.column - 2, mark.row - 2, 5, 5}, assets.colour(255, 240, 150));
        draw_text(canvas, mark.column + 6, mark.row - 4, "lamp", assets.text);
    }
    return figures;
}

/// The angle between two directions of the plane, degrees.
double degrees_between(PlanePoint a, PlanePoint b) {
    return std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y)) * 180 / std::numbers::pi;
}

/// The normal of a scaled surface in three ways: transformed as a point, by the inverse transpose, and as the cross
/// product of two scaled edges.
struct ScaledNormals {
    PlanePoint as_point, as_normal, of_edges;
};
ScaledNormals scaled_normals(const Matrix3& matrix, const Matrix3& normals, double angle) {
    const Vec3<Entry> normal{entry_of(std::cos(angle)), entry_of(std::sin(angle)), Entry{}};
    const Vec3<Entry> along{-normal.y, normal.x, Entry{}}, across{Entry{}, Entry{}, Entry::from_int(1)};
    const auto edges = cross(convert<World>(matrix * along), convert<World>(matrix * across));
    const Vec3<Entry> as_point = matrix * normal, as_normal = normals * normal;
    return {{number_of(as_point.x), number_of(as_point.y)},
            {number_of(as_normal.x), number_of(as_normal.y)},
            {number_of(edges.x), number_of(edges.y)}};
}

/// Seed 5 claims that scaling keeps normals normal; its erratum A7 shows that it does not. The cross product of two
/// edges, its other way to a normal, is always right.
Figures draw_normals(const RowInput& input, Framebuffer canvas) {
    const double scale = input.number(0) / 4;
    Diagram diagram(input, canvas, {0, 0}, 4.4);
    diagram.fill(input.colour(20, 24, 36));
    const std::uint8_t wrong = input.colour(220, 70, 60), right = input.colour(90, 210, 110),
                       edges = input.colour(250, 230, 120);
    Matrix3 matrix = Matrix3::identity();
    matrix.rows[0][0] = Entry::from_raw(input.values[0] * (std::int64_t{1} << 30));
    const std::optional<Matrix3> normals = normal_matrix(matrix);
    if (!normals) return {};
    const auto on_ellipse = [scale](double angle) { return PlanePoint{scale * std::cos(angle), std::sin(angle)}; };
    diagram.curve(
        96, [&](int step) { return on_ellipse(step * std::numbers::pi / 48); }, input.colour(150, 160, 180));
    double worst_normal = 0, worst_point = 0, expected_point = 0;
    for (int step = 0; step < 12; ++step) {
        const double angle = (step + 0.5) * std::numbers::pi / 6, c = std::cos(angle), s = std::sin(angle);
        const ScaledNormals found = scaled_normals(matrix, *normals, angle);
        const PlanePoint from = on_ellipse(angle);
        const auto arrow = [&](PlanePoint vector, double length, std::uint8_t colour) {
            const double size = length / std::hypot(vector.x, vector.y);
            diagram.arrow(from, {from.x + vector.x * size, from.y + vector.y * size}, colour);
        };
        arrow(found.as_point, 0.6, wrong);
        arrow(found.as_normal, 0.6, right);
        arrow(found.of_edges, 0.35, edges);
        worst_normal = std::max(worst_normal, degrees_between(found.as_normal, found.of_edges));
        worst_point = std::max(worst_point, degrees_between(found.as_point, found.of_edges));
        expected_point = std::max(expected_point, degrees_between({scale * c, s}, {c, scale * s}));
    }
    diagram.text({-0.9, 0.5}, "N = M n", wrong);
    diagram.text({-0.9, 0.15}, "N = M^-T n", right);
    diagram.text({-0.9, -0.2}, "N = M e0 x M e1", edges);
    const auto whole = [](int x, int y) { return Vec3<Entry>{Entry::from_int(x), Entry::from_int(y), Entry{}}; };
    const auto product = [&](const Vec3<Entry>& a, const Vec3<Entry>& b) {
        return number_of(a.x) * number_of(b.x) + number_of(a.y) * number_of(b.y) + number_of(a.z) * number_of(b.z);
    };
    const Vec3<Entry> tangent = matrix * whole(1, -1);
    return {number_figure("degrees from M^-T n to M e0 x M e1, worst", 0, worst_normal, 0.05),
            number_figure("degrees from M n to M e0 x M e1, worst", expected_point, worst_point, 0.05),
            number_figure("M n . M t of n (1, 1, 0), t (1, -1, 0)", scale * scale - 1,
                          product(matrix * whole(1, 1), tangent), 1e-9, 4),
            number_figure("M^-T n . M t", 0, product(*normals * whole(1, 1), tangent), 1e-6, 4)};
}

}  // namespace

std::vector<Row> shading_rows() {
    return {
        {"shading", draw_shadings, {{"rings of the ball", 4, 24, 1, 7}, {"light from, degrees", 0, 345, 15, 60}}},
        {"lights",
         draw_lights,
         {choice_parameter("light", {"ambient", "directional", "point"}, 1), {"light from, degrees", 0, 345, 15, 60}}},
        {"normals", draw_normals, {{"scale of x, quarters", 1, 12, 1, 8}}}};
}

}  // namespace oblong

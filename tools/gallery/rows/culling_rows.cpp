// Seed 5 (Abrash): back faces by a dot product, and why normals alone mislead.

#include <array>
#include <cmath>
#include <numbers>

#include "engine/methods/polygons.h"
#include "engine/raster/scan.h"
#include "engine/view/project.h"
#include "engine/view/views.h"
#include "tools/gallery/counted.h"
#include "tools/gallery/row.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

/// Quadrilaterals on a sphere, their corners clockwise seen from outside.
struct BallFace {
    std::array<Vec3<World>, 4> corners;
    Vec3<Unit> normal;
};

std::vector<BallFace> make_ball(double x, double y, double z, double radius) {
    constexpr int kAcross = 16, kUp = 8;
    const auto at = [&](int column, int row) {
        const double a = column * 2 * std::numbers::pi / kAcross, b = (row - kUp / 2) * std::numbers::pi / kUp;
        return world_point(x + radius * std::cos(a) * std::cos(b), y + radius * std::sin(a) * std::cos(b),
                           z + radius * std::sin(b));
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

Figures draw_culling(const RowInput& input, Framebuffer canvas) {
    fill(canvas, input.colour(18, 22, 34));
    const auto rule = static_cast<CullRule>(input.values[0]);
    const SketchEye from{world_point(0, 0, 0), world_point(100, 0, 0), static_cast<int>(input.values[1])};
    Sketch sketch(input, canvas, scene_area(canvas), from);
    const std::uint8_t right = input.colour(90, 110, 150), edge = input.colour(30, 34, 50);
    const std::uint8_t kept = input.colour(220, 60, 50), missing = input.colour(240, 200, 60);
    int faces = 0;
    std::array<int, 3> wrong{};  // by rule
    for (int column = -2; column <= 2; ++column)
        for (int row = -1; row <= 1; ++row)
            for (const BallFace& face : make_ball(60, column * 26.0, row * 26.0, 11)) {
                const bool faces_eye = faces_eye_in_double(face, from.eye);
                ++faces;
                for (const auto by : {CullRule::ObjectDot, CullRule::ViewNormal, CullRule::ScreenArea})
                    wrong[static_cast<std::size_t>(by)] +=
                        is_drawn(face, by, sketch.view()) != faces_eye &&
                        !(by == CullRule::ScreenArea && may_be_of_either_sign(face, sketch.view()));
                const bool draws = is_drawn(face, rule, sketch.view());
                if (faces_eye) {
                    sketch.polygon(face.corners, draws ? right : missing);
                    sketch.outline(face.corners, edge);
                } else if (draws) {
                    sketch.outline(face.corners, kept);
                }
            }
    const Vec3<Counted<double>> u{1, 2, 3}, v{4, -5, 6};
    const CountedOperations whole = operations_of([&] { cross_by_components(u, v); }),
                            third = operations_of([&] { cross_z(u, v); });
    draw_note(canvas, std::array{"cross product  " + whole.text(), "z of it alone  " + third.text()},
              input.assets.text);
    // Errata A9: (10, 0, 10), (11, 0, 12), (10, 1, 10) in viewspace has the normal (-2, 0, 1) and faces the eye.
    const Vec3<World> a = world_point(10, 0, 10), b = world_point(11, 0, 12), c = world_point(10, 1, 10);
    const auto normal = cross(b - a, c - a);
    return {count_figure("wrong by normal . (vertex - eye), in object space", 0, wrong[0]),
            measured("wrong by the normal's z in viewspace", std::to_string(wrong[1]) + " of " + std::to_string(faces)),
            count_figure("wrong by the sign of an area on the screen, beyond rounding", 0, wrong[2]),
            {"z of a cross product of edges: a third of 6 * 0 / 3 +", "2 * 0 / 1 +", third.text(),
             third == CountedOperations{2, 0, 1} && whole == CountedOperations{6, 0, 3}},
            number_figure(
                "normal . vertex of the seed's triangle, below 0: faces the eye", -10,
                number_of(dot(convert<WorldWide>(a), Vec3<Unit>{Unit::from_int(1), {}, {}})) * number_of(normal.x) +
                    number_of(a.z) * number_of(normal.z),
                1e-9),
            number_figure("its normal's z, above 0: points away", 1, number_of(normal.z), 1e-9)};
}

}  // namespace

std::vector<Row> culling_rows() {
    return {{"culling",
             draw_culling,
             {choice_parameter(
                  "drawn by",
                  {"dot product in object space", "normal's z in viewspace", "z of a cross product on the screen"}, 1),
              {"field of view, degrees", 30, 110, 10, 90}}}};
}

}  // namespace oblong

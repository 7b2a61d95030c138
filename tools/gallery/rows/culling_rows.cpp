// Seed 5 (Abrash): back faces by a dot product, and why normals alone mislead.

#include "engine/methods/polygons.h"
#include "engine/raster/scan.h"
#include "engine/view/project.h"
#include "tools/gallery/counted.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

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

/// Twice the area on the screen; the faces are all in front of the eye.
ScreenArea screen_area(const BallFace& face, const ViewContext& view) {
    std::array<ScreenVertex, 4> screen;
    for (std::size_t i = 0; i < 4; ++i) {
        const ScreenPosition p = project(to_view(face.corners[i], view), view.projection);
        screen[i] = {convert<Screen>(p.x), convert<Screen>(p.y)};
    }
    return doubled_area(screen);
}

bool is_drawn(const BallFace& face, CullRule rule, const ViewContext& view) {
    if (rule == CullRule::ObjectDot) return !faces_away(face.corners[1], face.normal, view.eye);
    if (rule == CullRule::ViewNormal) return !normal_points_away(face.normal, view.axes.forward);
    return screen_area(face, view) > ScreenArea{};
}

/// Whether a face faces the eye, in double precision.
bool faces_eye_in_double(const BallFace& face, const Vec3<World>& eye) {
    const auto& [a, b, c, d] = face.corners;
    return dot(cross(vec_of(d - b), vec_of(c - a)), vec_of(b - eye)) < 0;
}

Figures draw_culling(const RowInput& input, Canvas& canvas) {
    canvas.fill(kGround);
    const Vec3<World> eye;
    Sketch sketch(canvas, canvas.scene(), {vec_of(eye), {100, 0, 0}, static_cast<int>(input.values[1])});
    int faces = 0;
    std::array<int, 3> wrong{};  // by rule
    for (int column = -2; column <= 2; ++column)
        for (int row = -1; row <= 1; ++row)
            for (const BallFace& face : make_ball({60, column * 26.0, row * 26.0}, 11)) {
                const bool faces_eye = faces_eye_in_double(face, eye);
                ++faces;
                for (std::size_t by = 0; by < wrong.size(); ++by)
                    wrong[by] += is_drawn(face, static_cast<CullRule>(by), sketch.view()) != faces_eye;
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
            {"wrong by the sign of the area on the screen", 0, wrong[2]},
            {"z of a cross product of edges: a third of 6 * 0 / 3 +", "2 * 0 / 1 +", third.text(),
             third == CountedOperations{2, 0, 1} && whole == CountedOperations{6, 0, 3}},
            {"normal . vertex of the seed's triangle, below 0: faces the eye", -10, dot(vec_of(a), normal), 1e-9},
            {"its normal's z, above 0: points away", 1, normal.z, 1e-9}};
}

}  // namespace

std::vector<Row> culling_rows() {
    return {{"culling",
             draw_culling,
             {{"drawn by",
               {"dot product in object space", "normal's z in viewspace", "z of a cross product on the screen"},
               1},
              {"field of view, degrees", 30, 110, 10, 90}}}};
}

}  // namespace oblong

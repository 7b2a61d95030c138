// Points through every view by the engine's own way, against closed forms in doubles.

#include "engine/view/views.h"

#include <gtest/gtest.h>

#include "engine/base/input_error.h"
#include "engine/fixed/trig.h"
#include "tests/support/random.h"
#include "tests/support/refusal.h"

namespace oblong::test::views_test {
namespace {

struct Pixel {
    double x, y;
};
Pixel shown(const ViewContext& view, const Vec3<World>& point) {
    const ScreenPosition position = project(to_view(point, view), view.projection);
    return {number_of(position.x), number_of(position.y)};
}

/// Of a cube of 64 units from the origin, which is in the middle of the screen and the cube's left bottom corner there;
/// right and top in sizes of the cube.
void expect_extents(const ViewSpec& spec, const ScreenMode& mode, double right, double top) {
    ASSERT_FALSE(problem_of(spec, mode)) << *problem_of(spec, mode);
    const ViewContext view = make_view_context(spec, mode);
    Pixel least{1e9, 1e9}, most{-1e9, -1e9};
    for (int corner = 0; corner < 8; ++corner) {
        const Pixel at = shown(view, point_at(corner & 1 ? 64 : 0, corner & 2 ? 64 : 0, corner & 4 ? 64 : 0));
        least = {std::min(least.x, at.x), std::min(least.y, at.y)};
        most = {std::max(most.x, at.x), std::max(most.y, at.y)};
    }
    const double per_unit = mode.width_px / (2 * number_of(spec.window.half_width));
    const double pixel = 4.0 / 3 * mode.height_px / mode.width_px;  // its width to its height
    constexpr double kTolerance_px = 0.01;
    EXPECT_NEAR(least.x, mode.width_px / 2.0, kTolerance_px);
    EXPECT_NEAR(most.x, mode.width_px / 2.0 + 64 * right * per_unit, kTolerance_px);
    EXPECT_NEAR(most.y, mode.height_px / 2.0, kTolerance_px);
    EXPECT_NEAR(least.y, mode.height_px / 2.0 - 64 * top * per_unit * pixel, kTolerance_px);
}

const std::vector<ScreenMode> kModes{{320, 200, {4, 3}}, {640, 480, {4, 3}}, {320, 240, {4, 3}}};

TEST(ParallelViews, ShowASideOfACubeAsASquare) {
    for (const ScreenMode& mode : kModes)
        for (const ViewSide side : {ViewSide::Front, ViewSide::Top, ViewSide::Side})
            expect_extents(orthographic_view({}, side_axes(side), View::from_int(300)), mode, 1, 1);
}

double shortening(const Basis& axes, const Point& axis) {
    return std::hypot(dot(to_point(axes.right), axis), dot(to_point(axes.up), axis));
}

/// How many of three numbers differ from each other.
std::size_t different_of(std::array<double, 3> factors) {
    std::sort(factors.begin(), factors.end());
    return 1 + (factors[1] - factors[0] > 0.05) + (factors[2] - factors[1] > 0.05);
}

TEST(ParallelViews, HaveTheScalesThatTheirNamesSay) {
    struct Named {
        Axonometry kind;
        std::size_t different;          ///< iso: 1, di: 2, tri: 3
        std::array<double, 3> squares;  ///< of x, y, z: 1 less the squared part of each along the rays
    };
    for (const Named& named : {Named{Axonometry::Isometric, 1, {2 / 3.0, 2 / 3.0, 2 / 3.0}},
                               Named{Axonometry::Dimetric, 2, {2 / 9.0, 8 / 9.0, 8 / 9.0}},
                               Named{Axonometry::Trimetric, 3, {25 / 50.0, 34 / 50.0, 41 / 50.0}}})
        for (const int quarters : {0, 1, 2, 3}) {
            const Basis axes = axonometric_axes(named.kind, degrees_to_angle(Degrees::from_int(90 * quarters)));
            std::array<double, 3> factors{shortening(axes, {1, 0, 0}), shortening(axes, {0, 1, 0}),
                                          shortening(axes, {0, 0, 1})};
            if (quarters % 2 == 1) std::swap(factors[0], factors[1]);
            EXPECT_EQ(different_of(factors), named.different);
            // Of three axes at right angles, whatever the view: the squares add up to 2.
            EXPECT_NEAR(factors[0] * factors[0] + factors[1] * factors[1] + factors[2] * factors[2], 2, 1e-7);
            for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(factors[i], std::sqrt(named.squares[i]), 1e-8);
        }
}

TEST(ParallelViews, ShiftWhatIsFartherWhereOblique) {
    for (const ScreenMode& mode : kModes)
        for (const double share : {1.0, 0.5})
            for (const int degrees : {30, 45, 60}) {
                const double turn = degrees * 3.141592653589793 / 180;
                const ViewSpec view = oblique_view({}, side_axes(ViewSide::Front), View::from_int(300),
                                                   fixed_of<Unit>(share), degrees_to_angle(Degrees::from_int(degrees)));
                // Binary angles are within 0.003 degrees.
                expect_extents(view, mode, 1 + share * std::cos(turn), 1 + share * std::sin(turn));
            }
}

// The lab's table: 200x200 pixels; its far corners as corrected (errata L1).
TEST(WindowViews, ShowTheLabsCubeWhereItsGeometrySays) {
    WindowView window;
    window.reference_point = point_at(0.5, 0.5, -2);
    window.normal = point_at(0, 0, -1);
    window.up = point_at(0, 1, 0);
    window.centre_of_projection = point_at(0.5, 0.5, -4);
    window.u_min = window.v_min = fixed_of<World>(-0.5);
    window.u_max = window.v_max = fixed_of<World>(0.5);
    const ScreenMode mode{200, 200, {1, 1}};
    const ViewSpec spec = window_view(window);
    ASSERT_FALSE(problem_of(spec, mode));
    const ViewContext view = make_view_context(spec, mode);
    for (int corner = 0; corner < 8; ++corner) {
        const int x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
        const Pixel pixel = shown(view, point_at(x, y, z));
        EXPECT_EQ(pixel.x, z ? (x ? 60 : 140) : (x ? 50 : 150));
        EXPECT_EQ(pixel.y, z ? (y ? 60 : 140) : (y ? 50 : 150));
    }
    window.normal = point_at(0, 0, 3);  // the other way and of another length: the eye says which way is ahead
    EXPECT_EQ(window_view(window).axes, spec.axes);
}

struct RandomWindow {
    WindowView window;
    double du, dv;
};
RandomWindow random_window(std::mt19937& random, bool is_parallel) {
    const auto within = [&](double reach) { return random_between(random, -reach, reach); };
    const auto point = [&](double reach) { return point_at(within(reach), within(reach), within(reach)); };
    RandomWindow made;
    WindowView& window = made.window;
    window.is_parallel = is_parallel;
    window.reference_point = point(1000);
    window.normal = point(1);
    window.up = point(1);
    window.centre_of_projection = window.reference_point + point(300);
    made.du = 100 + within(50);
    made.dv = made.du * 3 / 4;
    const double u = within(100), v = within(100);
    window.u_min = fixed_of<World>(u), window.u_max = fixed_of<World>(u + made.du);
    window.v_min = fixed_of<World>(v), window.v_max = fixed_of<World>(v + made.dv);
    return made;
}

// Where the parts make a view at all, the window's corners are the screen's.
TEST(WindowViews, ShowTheirWindowOnTheWholeScreen) {
    std::mt19937 random(2);
    const ScreenMode mode{320, 200, {4, 3}};
    int views = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto [window, du, dv] = random_window(random, i % 2 == 1);
        ViewSpec spec;
        try {
            spec = window_view(window);
        } catch (const InputError&) {
            continue;
        }
        // A step of the world is more than a hundredth of a pixel there.
        if (problem_of(spec, mode) || spec.window.distance < View::from_int(20)) continue;
        ++views;
        const ViewContext view = make_view_context(spec, mode);
        const Point right = to_point(spec.axes.right), up = to_point(spec.axes.up);
        for (int corner = 0; corner < 4; ++corner) {
            const double u = number_of(corner & 1 ? window.u_max : window.u_min);
            const double v = number_of(corner & 2 ? window.v_max : window.v_min);
            const Pixel pixel = shown(view, window.reference_point + to_world(right * u + up * v));
            EXPECT_NEAR(pixel.x, corner & 1 ? 320 : 0, 0.02);
            EXPECT_NEAR(pixel.y, corner & 2 ? 0 : 200, 0.02);
        }
    }
    EXPECT_GT(views, 500);
}

TEST(WindowViews, ShowAWindowOfAnotherShapeWholeAndUndistorted) {
    WindowView window;
    window.normal = point_at(0, 1, 0);
    window.up = point_at(0, 0, 1);
    window.centre_of_projection = point_at(0, -100, 0);
    window.u_min = fixed_of<World>(-10), window.u_max = fixed_of<World>(10);
    window.v_min = fixed_of<World>(-60), window.v_max = fixed_of<World>(60);
    const ViewContext view = make_view_context(window_view(window), {320, 200, {4, 3}});
    EXPECT_NEAR(shown(view, point_at(0, 0, 60)).y, 0, 0.01);
    EXPECT_NEAR(shown(view, point_at(0, 0, -60)).y, 200, 0.01);
    EXPECT_NEAR(shown(view, point_at(10, 0, 0)).x, 160 + 10 * (100 / 60.0) / (5 / 6.0), 0.01);  // pixels are 5:6
}

TEST(WindowViews, SayWhatIsWrong) {
    WindowView good;
    good.normal = point_at(0, 1, 0), good.up = point_at(0, 0, 1), good.centre_of_projection = point_at(0, -100, 0);
    good.u_min = good.v_min = fixed_of<World>(-10), good.u_max = good.v_max = fixed_of<World>(10);
    const auto refused = [](const WindowView& window) { return refusal([&] { window_view(window); }); };
    EXPECT_EQ(refused(good), "");
    const std::vector<std::pair<void (*)(WindowView&), const char*>> cases{
        {[](WindowView& w) { w.normal = {}; }, "VPN: is zero, expected a direction"},
        {[](WindowView& w) { w.up = point_at(0, -2, 0); }, "VUP: is zero or along the VPN, expected another direction"},
        {[](WindowView& w) { w.centre_of_projection = point_at(5, 0, 3); },
         "COP: is in the view plane, expected it before or behind"},
        {[](WindowView& w) { w.u_max = w.u_min; },
         "window: is empty, expected u_min below u_max and v_min below v_max"},
        {[](WindowView& w) { w.u_min = fixed_of<World>(150), w.u_max = fixed_of<World>(190); },
         "window: its middle is more than 45 degrees from straight ahead, expected less"}};
    for (const auto& [spoil, message] : cases) {
        WindowView window = good;
        spoil(window);
        EXPECT_EQ(refused(window), message);
    }
}

TEST(Views, SayWhatKeepsThemFromBeingDrawn) {
    const Basis top = side_axes(ViewSide::Top);
    const ViewSpec far = oblique_view(point_at(300'000, 0, 0), top, View::from_int(100), Unit::from_int(1), {});
    ViewSpec askew = far;
    askew.eye = {};
    askew.shear_y = Unit::from_raw(1 << 28);
    for (const auto& [view, problem] :
         {std::pair{orthographic_view({}, top, View::from_raw(40)), "0 units wide"},
          {orthographic_view({}, top, kWidestParallel + View::from_raw(2)), "1048576 units wide"},
          {far, "262,144"},
          {askew, "45 degrees"}})
        EXPECT_NE(problem_of(view, {}).value_or("").find(problem), std::string::npos) << problem;
    for (const View width : {kNarrowestParallel, kWidestParallel})
        EXPECT_FALSE(problem_of(orthographic_view({}, top, width), {}));
    EXPECT_FALSE(problem_of(first_person_view({}), {}));
}

TEST(LookAt, ShowsItsTargetInTheMiddleUpright) {
    std::mt19937 random(3);
    const auto within = [&](double reach) { return random_between(random, -reach, reach); };
    for (int i = 0; i < 200; ++i) {
        const Vec3<World> target = point_at(within(500), within(500), within(500));
        const Vec3<World> eye = target + point_at(within(200), 20 + std::abs(within(200)), within(200));
        const ViewContext view = make_view_context(look_at_view(eye, target, Degrees::from_int(90)), {});
        const Pixel middle = shown(view, target), above = shown(view, target + point_at(0, 0, 5));
        EXPECT_NEAR(middle.x, 160, 0.01);
        EXPECT_NEAR(middle.y, 100, 0.01);
        EXPECT_NEAR(above.x, 160, 0.01);
        EXPECT_LT(above.y, 100);
    }
}

// Zoom against dolly: what is at the distance keeps its size, what is behind it does not.
TEST(DollyZoom, KeepsTheSizeOfWhatIsAtItsDistance) {
    Camera camera;
    camera.eye = point_at(10, -20, 30);
    camera.yaw = Angle{0x1234}, camera.pitch = Angle{0x0321};
    const Basis axes = view_basis(camera.yaw, camera.pitch, {});
    const auto ahead = [&](double depth, double across) {
        const Point f = to_point(axes.forward), r = to_point(axes.right);
        return camera.eye + to_world(f * depth + r * across);
    };
    const auto size_at = [&](const Camera& from, double depth) {
        const ViewContext view = make_view_context(first_person_view(from), {});
        return shown(view, ahead(depth, 20)).x - shown(view, ahead(depth, -20)).x;
    };
    double behind_before = 1e9;
    for (const int degrees : {20, 40, 60, 90, 110}) {
        const Camera zoomed = dolly_zoomed(camera, World::from_int(200), Degrees::from_int(degrees));
        EXPECT_NEAR(size_at(zoomed, 200), size_at(camera, 200), 0.02) << degrees;
        const double behind = size_at(zoomed, 400);
        EXPECT_LT(behind, behind_before - 0.5);
        behind_before = behind;
    }
    EXPECT_EQ(dolly_zoomed(camera, World::from_int(200), camera.field_of_view).eye, camera.eye);
}

// x right + y up + z forward of the rays is back where the axes came from (P5: the matrix of a view and its inverse).
TEST(ViewContexts, HaveRaysThatAreTheInverseOfTheirAxes) {
    std::mt19937 random(5);
    for (int i = 0; i < 500; ++i) {
        ViewSpec spec = first_person_view({{}, random_angle(random), random_angle(random), random_angle(random)});
        spec.shear_x = fixed_of<Unit>(random_between(random, -0.5, 0.5));
        spec.shear_y = fixed_of<Unit>(random_between(random, -0.5, 0.5));
        const ViewContext view = make_view_context(spec, {});
        const std::array<Point, 3> rows{to_point(view.axes.right), to_point(view.axes.up), to_point(view.axes.forward)};
        const std::array<Point, 3> columns{to_point(view.rays.right), to_point(view.rays.up),
                                           to_point(view.rays.forward)};
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                EXPECT_NEAR(dot(rows[row], columns[column]), row == column ? 1 : 0, 1e-8);
    }
}

}  // namespace
}  // namespace oblong::test::views_test

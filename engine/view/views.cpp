#include "engine/view/views.h"

#include <algorithm>
#include <bit>

#include "engine/base/input_error.h"
#include "engine/fixed/trig.h"

namespace oblong {

namespace {

/// v + step * along.
Vec3<Unit> sheared(const Vec3<Unit>& v, Unit step, const Vec3<Unit>& along) {
    const auto part = [step](Unit component) { return product<Unit>(step, component); };
    return v + Vec3<Unit>{part(along.x), part(along.y), part(along.z)};
}

/// Opposite to the rays, 2^14 units long.
Vec3<World> toward_viewer(const Vec3<Unit>& ray) {
    const auto part = [](Unit component) { return World::from_raw(-floor_of<26>(component)); };
    return {part(ray.x), part(ray.y), part(ray.z)};
}

bool is_far(const Vec3<World>& eye) {
    return std::max({absolute(eye.x), absolute(eye.y), absolute(eye.z)}) > kFarthestShearedEye;
}

std::optional<std::string> problem_of_window(const ViewSpec& spec, const ScreenMode& mode) {
    const ViewWindow& window = spec.window;
    if (window.half_width <= View{} || window.half_height < View{} || window.distance <= View{})
        return "a window without a size, or in the eye's own plane, expected one before the eye";
    if (!spec.is_parallel) return std::nullopt;
    const View width = shown_half_width(window, mode) * 2;
    if (width < kNarrowestParallel || width > kWidestParallel)
        return "a parallel view " + std::to_string(floor_of(width)) + " units wide, expected 1 to 1,048,576";
    return std::nullopt;
}

/// The depth of all points in a parallel view: a power of two, so that 1/z is exact in any format, and at least half
/// the width, as in views of at most 90 degrees.
View depth_of(View half_width) {
    return View::from_raw(static_cast<std::int64_t>(std::bit_ceil(half_width.bits())));
}

}  // namespace

std::optional<std::string> problem_of(const ViewSpec& spec, const ScreenMode& mode) {
    if (const auto problem = problem_of_window(spec, mode)) return problem;
    const Sine60 square = bounded_product(spec.shear_x, spec.shear_x) + bounded_product(spec.shear_y, spec.shear_y);
    if (square > bounded_product(kLargestShear, kLargestShear))
        return "a view whose middle is more than 45 degrees from straight ahead, expected less";
    if ((spec.shear_x != Unit{} || spec.shear_y != Unit{}) && is_far(spec.eye))
        return "a sheared view from beyond 262,144 units, expected an eye nearer to the world's origin";
    // A parallel view's depth is at least this (depth_of).
    const ViewWindow window = spec.is_parallel ? ViewWindow{View::from_int(1), View::from_int(1)} : spec.window;
    if (!is_drawable(make_projection(mode, window)))
        return "a view so wide that a unit at depth 1 is less than half a pixel, expected a narrower one or a larger "
               "mode";
    return std::nullopt;
}

ViewContext make_view_context(const ViewSpec& spec, const ScreenMode& mode, const ViewPrecision& precision) {
    const Basis axes = rounded_to(spec.axes, precision.matrix_bits);
    ViewContext view;
    view.eye = spec.eye;
    view.viewpoint = {spec.eye};
    view.axes = {sheared(axes.right, -spec.shear_x, axes.forward), sheared(axes.up, -spec.shear_y, axes.forward),
                 axes.forward};
    view.rays = {axes.right, axes.up, sheared(sheared(axes.forward, spec.shear_x, axes.right), spec.shear_y, axes.up)};
    ViewWindow window = spec.window;
    if (spec.is_parallel) {
        window.distance = view.parallel_depth = depth_of(shown_half_width(window, mode));
        view.axes.forward = {};
        view.viewpoint = {toward_viewer(view.rays.forward), 0};
    }
    view.projection = make_projection(mode, window, precision.corrects_aspect);
    view.frustum = make_frustum(view.axes, view.projection, view.parallel_depth);
    view.grid = SubpixelGrid::of_bits(precision.subpixel_bits);
    view.view_bits = precision.view_bits;
    view.adjusts_positions = spec.is_parallel || precision.view_bits != View::kFractionBits;
    view.shows_void = spec.is_parallel || !spec.cuts.empty();
    return view;
}

namespace {

constexpr Vec3<Unit> kWorldUp{{}, {}, Unit::from_int(1)};

/// The axes of a view along (x, y, z), z up, turned about z. Components are below 2^29.
Basis axes_along(std::int32_t x, std::int32_t y, std::int32_t z, Angle turn) {
    const auto turned = [](std::int32_t by_cosine, Unit cosine, std::int32_t by_sine, Unit sine) {
        return product<World>(World::from_raw(by_cosine), cosine) + product<World>(World::from_raw(by_sine), sine);
    };
    const Unit c = cosine(turn), s = sine(turn);
    return look_at({}, {turned(x, c, -y, s), turned(y, c, x, s), World::from_raw(z)}, kWorldUp);
}

ViewCut cut_along(const Vec3<Unit>& normal, const Vec3<World>& from, World distance) {
    return {normal, dot(from, normal) + convert<PlaneDistance>(distance)};
}

/// The coordinate of p along an axis from the reference point, rounded to View.
View along(const Vec3<Unit>& axis, const Vec3<World>& p, const Vec3<World>& reference_point) {
    return view_coordinate(widening_difference(p, reference_point), axis);
}

View half_way(World low, World high) {
    return convert<View>(floor_shift(convert<View>(low) + convert<View>(high), 1));
}

/// The axes of a view from the centre of projection toward the window's plane.
Basis axes_of(const WindowView& window) {
    const Vec3<Unit> normal = normalised(window.normal), up = normalised(window.up);
    if (normal == Vec3<Unit>{}) throw InputError("VPN", "is zero, expected a direction");
    const View ahead = along(normal, window.reference_point, window.centre_of_projection);
    if (ahead == View{}) throw InputError("COP", "is in the view plane, expected it before or behind");
    Basis axes;
    axes.forward = ahead > View{} ? normal : -normal;
    axes.right = normalised(cross(axes.forward, up));
    if (axes.right == Vec3<Unit>{}) throw InputError("VUP", "is zero or along the VPN, expected another direction");
    axes.up = normalised(cross(axes.right, axes.forward));
    return axes;
}

Unit shear_of(View across, View distance) {
    if (absolute(across) > distance)
        throw InputError("window", "its middle is more than 45 degrees from straight ahead, expected less");
    return divide<Unit>(across, distance);
}

}  // namespace

ViewSpec first_person_view(const Camera& camera, SineMethod sine) {
    ViewSpec view;
    view.eye = camera.eye;
    view.axes = view_basis(camera.yaw, camera.pitch, camera.roll, sine);
    view.window = window_of(camera.field_of_view);
    return view;
}

ViewSpec look_at_view(const Vec3<World>& eye, const Vec3<World>& target, Degrees field_of_view) {
    ViewSpec view;
    view.eye = eye;
    view.axes = look_at(eye, target, kWorldUp);
    view.window = window_of(field_of_view);
    return view;
}

Camera dolly_zoomed(const Camera& camera, World distance, Degrees field_of_view) {
    const ViewWindow before = window_of(camera.field_of_view), after = window_of(field_of_view);
    // distance * tan before / tan after; the windows' members are at most 1.
    const auto wide = product<Sine60>(Sine60::from_raw(before.half_width.raw), Sine60::from_raw(after.distance.raw));
    const auto narrow = product<Sine60>(Sine60::from_raw(after.half_width.raw), Sine60::from_raw(before.distance.raw));
    const auto back =
        product_over<WorldWide>(convert<WorldWide>(distance), wide, narrow) - convert<WorldWide>(distance);
    const Vec3<Unit> forward = view_basis(camera.yaw, camera.pitch, camera.roll).forward;
    const auto moved = [back](World from, Unit component) {
        return saturating_convert<World>(convert<WorldWide>(from) - product<WorldWide>(back, component));
    };
    Camera zoomed = camera;
    zoomed.eye = {moved(camera.eye.x, forward.x), moved(camera.eye.y, forward.y), moved(camera.eye.z, forward.z)};
    zoomed.field_of_view = field_of_view;
    return zoomed;
}

ViewSpec orthographic_view(const Vec3<World>& centre, const Basis& axes, View width) {
    ViewSpec view;
    view.is_parallel = true;
    view.eye = centre;
    view.axes = axes;
    view.window = {floor_shift(width, 1), View::from_int(1)};
    return view;
}

Basis side_axes(ViewSide side) {
    constexpr Unit kOne = Unit::from_int(1);
    constexpr Vec3<Unit> kEast{kOne, {}, {}}, kNorth{{}, kOne, {}};
    if (side == ViewSide::Front) return {kEast, kWorldUp, kNorth};
    if (side == ViewSide::Top) return {kEast, kNorth, -kWorldUp};
    return {kNorth, kWorldUp, -kEast};
}

Basis axonometric_axes(Axonometry kind, Angle turn) {
    constexpr std::int32_t kUnit = 100'000'000;
    if (kind == Axonometry::Isometric) return axes_along(kUnit, kUnit, -kUnit, turn);
    // Along (sqrt 7, 1, -1): x is foreshortened to sqrt 2 / 3, y and z to twice that.
    if (kind == Axonometry::Dimetric) return axes_along(264'575'131, kUnit, -kUnit, turn);
    return axes_along(5 * kUnit, 4 * kUnit, -3 * kUnit, turn);
}

ViewSpec oblique_view(const Vec3<World>& centre, const Basis& axes, View width, Unit length, Angle angle) {
    ViewSpec view = orthographic_view(centre, axes, width);
    view.shear_x = -product<Unit>(length, cosine(angle));
    view.shear_y = -product<Unit>(length, sine(angle));
    return view;
}

ViewSpec window_view(const WindowView& window) {
    if (window.u_min >= window.u_max || window.v_min >= window.v_max)
        throw InputError("window", "is empty, expected u_min below u_max and v_min below v_max");
    ViewSpec view;
    view.axes = axes_of(window);
    const Vec3<World>&cop = window.centre_of_projection, &vrp = window.reference_point;
    const View distance = along(view.axes.forward, vrp, cop);
    const View middle_u = half_way(window.u_min, window.u_max), middle_v = half_way(window.v_min, window.v_max);
    view.shear_x = shear_of(along(view.axes.right, vrp, cop) + middle_u, distance);
    view.shear_y = shear_of(along(view.axes.up, vrp, cop) + middle_v, distance);
    view.is_parallel = window.is_parallel;
    view.eye = cop;
    view.window = {floor_shift(convert<View>(window.u_max) - convert<View>(window.u_min), 1), distance,
                   floor_shift(convert<View>(window.v_max) - convert<View>(window.v_min), 1)};
    if (window.front) cut_front(view, vrp, *window.front);
    if (window.back) cut_back(view, vrp, *window.back);
    return view;
}

void cut_front(ViewSpec& view, const Vec3<World>& from, World distance) {
    view.cuts.push_back(cut_along(view.axes.forward, from, distance));
}

void cut_back(ViewSpec& view, const Vec3<World>& from, World distance) {
    view.cuts.push_back(cut_along(-view.axes.forward, from, -distance));
}

void cut_above(ViewSpec& view, World height) {
    view.cuts.push_back(cut_along(-kWorldUp, {}, -height));
}

}  // namespace oblong

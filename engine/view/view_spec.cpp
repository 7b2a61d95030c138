#include "engine/view/view_spec.h"

#include <algorithm>
#include <bit>

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

}  // namespace oblong

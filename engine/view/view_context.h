#pragma once

#include "engine/math/basis.h"
#include "engine/view/frustum.h"
#include "engine/view/project.h"
#include "engine/view/projection.h"

namespace oblong {

/// Where the rays of a view come from, in homogeneous coordinates: the eye (w = 1), or, where all rays are parallel, a
/// direction (w = 0), 2^14 units long and toward the viewer. Order and facing ask for sides of it only, and so serve
/// both.
struct Viewpoint {
    Vec3<World> position;
    std::int64_t weight_mask = -1;  ///< of what w is to multiply: all bits, or none

    bool is_direction() const { return weight_mask == 0; }
    /// As seen from a model that is moved by `offset`.
    Viewpoint relative_to(const Vec3<World>& offset) const {
        return is_direction() ? *this : Viewpoint{position - offset};
    }
};

/// Everything that a frame transforms its vertices with. A point p is at axes * (p - eye) + (0, 0, parallel_depth) in
/// viewspace, and projection divides x and y of that by z. So in a parallel view, whose `axes.forward` is zero, all
/// points have one depth. What a view is sheared by (off-centre windows, oblique projections) is in the axes: right and
/// up each lose their part of forward, and the window is in the middle again.
struct ViewContext {
    Vec3<World> eye;  ///< in a parallel view a point that is shown in the middle
    Viewpoint viewpoint;
    Basis axes;  ///< to viewspace
    Basis rays;  ///< back again: x right + y up + z forward. The same as `axes` unless the view is sheared or parallel
    View parallel_depth;  ///< 0: a perspective view
    Projection projection;
    Frustum frustum;
    SubpixelGrid grid;
    std::int32_t view_bits = View::kFractionBits;  ///< of positions in viewspace
    bool adjusts_positions = false;                ///< view_bits or parallel_depth are to be obeyed
    bool shows_void = false;  ///< pixels may show nothing: the view is parallel, or planes cut parts of it off

    bool is_parallel() const { return parallel_depth != View{}; }
    /// The axes for directions through pixels: in a parallel view there is one direction.
    Basis ray_directions() const { return is_parallel() ? Basis{{}, {}, rays.forward} : rays; }
};

/// What a position becomes where the view adjusts positions.
inline Vec3<View> adjusted(Vec3<View> position, const ViewContext& view) {
    position.z += view.parallel_depth;
    return rounded_to(position, view.view_bits);
}

/// A point of the world in viewspace.
inline Vec3<View> to_view(const Vec3<World>& point, const ViewContext& view) {
    const Vec3<View> position = to_view(point, view.eye, view.axes);
    return view.adjusts_positions ? adjusted(position, view) : position;
}

}  // namespace oblong

#pragma once

#include "engine/math/basis.h"
#include "engine/view/frustum.h"
#include "engine/view/project.h"
#include "engine/view/projection.h"

namespace oblong {

/// The origin of a view's rays, in homogeneous coordinates: the eye (w = 1) or, for parallel rays, a direction (w = 0),
/// 2^14 units long, toward the viewer. Front-to-back order and facing need only the side of planes that it is on, so
/// both kinds work alike.
struct Viewpoint {
    Vec3<World> position;
    std::int64_t weight_mask = -1;  ///< a mask that multiplies by w: all bits, or none

    bool is_direction() const { return weight_mask == 0; }
    /// Relative to a model that is moved by `offset`.
    Viewpoint relative_to(const Vec3<World>& offset) const {
        return is_direction() ? *this : Viewpoint{position - offset};
    }
};

/// Everything needed to transform a frame's vertices. In viewspace a point p is at axes * (p - eye) + (0, 0,
/// parallel_depth); projection divides x and y by z. In a parallel view `axes.forward` is zero, so all points have the
/// same depth. The shear of off-centre windows and oblique projections is in the axes: a part of forward is subtracted
/// from right and up, which centres the window.
struct ViewContext {
    Vec3<World> eye;  ///< in a parallel view a point shown in the middle
    Viewpoint viewpoint;
    Basis axes;  ///< to viewspace
    Basis rays;  ///< from viewspace: x right + y up + z forward; equal to `axes` unless the view is sheared or parallel
    View parallel_depth;  ///< 0: perspective view
    Projection projection;
    Frustum frustum;
    SubpixelGrid grid;
    std::int32_t view_bits = View::kFractionBits;  ///< of positions in viewspace
    bool adjusts_positions = false;                ///< view_bits or parallel_depth apply
    bool shows_void = false;                       ///< pixels may show nothing: the view is parallel or has cuts

    bool is_parallel() const { return parallel_depth != View{}; }
    /// The axes for directions through pixels; in a parallel view all have one direction.
    Basis ray_directions() const { return is_parallel() ? Basis{{}, {}, rays.forward} : rays; }
};

/// Applies view_bits and parallel_depth.
inline Vec3<View> adjusted(Vec3<View> position, const ViewContext& view) {
    position.z += view.parallel_depth;
    return rounded_to(position, view.view_bits);
}

inline Vec3<View> to_view(const Vec3<World>& point, const ViewContext& view) {
    const Vec3<View> position = to_view(point, view.eye, view.axes);
    return view.adjusts_positions ? adjusted(position, view) : position;
}

}  // namespace oblong

#pragma once

#include <optional>
#include <type_traits>

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

/// to_view() in 32 bits; none for points 2^12 units or more from the eye along an axis of the world. (Components of
/// sheared axes are below 2, so the sum of three products is below 6 * 2^12 units.)
[[gnu::always_inline]] inline std::optional<Vec3<ShortView>> to_short_view(const Vec3<World>& point,
                                                                           const ViewContext& view) {
    constexpr std::uint32_t kEnd = 1u << (World::kFractionBits + 12);
    Vec3<World> from_eye;
    if (__builtin_sub_overflow(point.x.raw, view.eye.x.raw, &from_eye.x.raw) ||
        __builtin_sub_overflow(point.y.raw, view.eye.y.raw, &from_eye.y.raw) ||
        __builtin_sub_overflow(point.z.raw, view.eye.z.raw, &from_eye.z.raw) ||
        ((from_eye.x.bits() + kEnd) | (from_eye.y.bits() + kEnd) | (from_eye.z.bits() + kEnd)) >= 2 * kEnd)
        return std::nullopt;
    const auto along = [&](const Vec3<Unit>& axis) {
        return ShortView::from_raw(static_cast<std::int32_t>(convert<View>(dot(from_eye, axis)).raw));
    };
    return Vec3<ShortView>{along(view.axes.right), along(view.axes.up), along(view.axes.forward)};
}

/// A position in viewspace without view_bits and parallel_depth.
inline Vec3<View> to_unadjusted_view(const Vec3<World>& point, const ViewContext& view) {
    if constexpr (native::kHasShortRegisters)
        if (const auto near = to_short_view(point, view))
            return {convert<View>(near->x), convert<View>(near->y), convert<View>(near->z)};
    return to_view(point, view.eye, view.axes);
}

/// Sets a vertex's outcode from its position in viewspace, which may be that of 32 bits, and if it is inside the view
/// its place on the screen. Returns whether it is inside.
template <class Position, class Vertex>
[[gnu::always_inline]] inline bool place_vertex_at(const Vec3<Position>& position, const ViewContext& view,
                                                   Vertex& vertex) {
    if constexpr (std::is_same_v<Position, ShortView>) {
        ScreenVertex screen;
        if (project_near(position, view.projection, screen) && is_well_inside(screen, view.projection)) [[likely]] {
            vertex.outcode = 0;
            vertex.screen = {view.grid.snap(screen.x), view.grid.snap(screen.y)};
            return true;
        }
    }
    vertex.outcode = outcode_of(view.frustum, position);
    if (vertex.outcode != 0) return false;
    vertex.screen = to_screen_vertex(vertex.position, view.projection, view.grid);
    return true;
}

/// The same; also sets the position from its place in the world.
template <bool AdjustsPositions, class Vertex>
[[gnu::always_inline]] inline bool place_vertex(const Vec3<World>& point, const ViewContext& view, Vertex& vertex) {
    if constexpr (native::kHasShortRegisters && !AdjustsPositions)
        if (const auto near = to_short_view(point, view)) {
            vertex.position = convert<View>(*near);
            return place_vertex_at(*near, view, vertex);
        }
    vertex.position = to_view(point, view.eye, view.axes);
    if constexpr (AdjustsPositions) vertex.position = adjusted(vertex.position, view);
    return place_vertex_at(vertex.position, view, vertex);
}
template <class Vertex>
[[gnu::always_inline]] inline bool place_vertex(const Vec3<World>& point, const ViewContext& view, Vertex& vertex) {
    if (view.adjusts_positions) return place_vertex<true>(point, view, vertex);
    return place_vertex<false>(point, view, vertex);
}

}  // namespace oblong

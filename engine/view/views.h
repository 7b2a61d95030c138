#pragma once

#include <optional>

#include "engine/view/view_spec.h"

namespace oblong {

// Functions that make views. World axes: x east, y north, z up, right-handed.

ViewSpec first_person_view(const Camera& camera, SineMethod sine = SineMethod::NearestStep);

/// From `eye` toward `target`, z up (course notes).
ViewSpec look_at_view(const Vec3<World>& eye, const Vec3<World>& target, Degrees field_of_view);

/// Dolly zoom: changes the field of view and moves the eye back or forth so that the size at `distance` ahead stays the
/// same. The eye stays within the world's limits.
Camera dolly_zoomed(const Camera& camera, World distance, Degrees field_of_view);

/// A parallel projection along forward, at right angles to the view plane; `width` units across the screen.
ViewSpec orthographic_view(const Vec3<World>& centre, const Basis& axes, View width);

/// Axes for orthographic_view() and oblique_view(): from the south, from above with north up, from the east.
enum class ViewSide { Front, Top, Side };
Basis side_axes(ViewSide side);

/// Axes for orthographic_view(), from above and the south-west. The world's axes are foreshortened equally (isometric),
/// two of them equally (dimetric, x half as long as y and z: 7 and 42 degrees of engineering drawings), or each
/// differently (trimetric: the roots of 25, 34 and 41 fiftieths). `turn` turns the view counter-clockwise about z.
enum class Axonometry { Isometric, Dimetric, Trimetric };
Basis axonometric_axes(Axonometry kind, Angle turn = {});

/// An oblique parallel projection: each unit of depth moves a point by `length` units along `angle` (counter-clockwise
/// from right). `length` is 0 to 1; 1: cavalier, 1/2: cabinet (Princeton: x + L cos a z, y + L sin a z).
ViewSpec oblique_view(const Vec3<World>& centre, const Basis& axes, View width, Unit length, Angle angle);

/// A view as defined by PHIGS and the lab: a plane through the view reference point, a window in it, and a centre of
/// projection; all in world axes.
struct WindowView {
    Vec3<World> reference_point;
    Vec3<World> normal;  ///< VPN, of any length and sign: forward is from the centre of projection to the plane
    Vec3<World> up;      ///< VUP, of any length, not along the normal
    Vec3<World> centre_of_projection;
    World u_min, u_max, v_min, v_max;  ///< the window, relative to the reference point: u right, v up
    std::optional<World> front, back;  ///< depths from the reference point, away from the eye; limits of the view
    bool is_parallel = false;          ///< along the line from the centre of projection to the window's middle
};

/// u is VUP x VPN with a VPN toward the viewer, in right-handed axes (the lab's table; its text does not give the
/// handedness). The whole window is shown; on a screen of another shape more is visible around it. Throws InputError if
/// the members do not define a view.
ViewSpec window_view(const WindowView& window);

/// Adds a plane at right angles to forward, `distance` from a point; keeps what is behind it (front) or before it
/// (back).
void cut_front(ViewSpec& view, const Vec3<World>& from, World distance);
void cut_back(ViewSpec& view, const Vec3<World>& from, World distance);
/// Keeps what is below this height, for example a building without its roof.
void cut_above(ViewSpec& view, World height);

}  // namespace oblong

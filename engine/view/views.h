#pragma once

#include <optional>

#include "engine/view/view_spec.h"

namespace oblong {

// Views by the words of those who ask for them. All are in the world's axes: x east, y north, z up, right-handed.

/// As the camera looks.
ViewSpec first_person_view(const Camera& camera, SineMethod sine = SineMethod::NearestStep);

/// From an eye toward a target, z up (course notes).
ViewSpec look_at_view(const Vec3<World>& eye, const Vec3<World>& target, Degrees field_of_view);

/// The same size of what is at `distance` ahead with another field of view: the eye moves back or forth ("zoom against
/// dolly"). The eye stays within the world's limits.
Camera dolly_zoomed(const Camera& camera, World distance, Degrees field_of_view);

/// Parallel along -forward of the axes onto a plane at right angles; `width` units across the screen.
ViewSpec orthographic_view(const Vec3<World>& centre, const Basis& axes, View width);

/// Axes for orthographic_view() and oblique_view(): from the south, from above with north up, from the east.
enum class ViewSide { Front, Top, Side };
Basis side_axes(ViewSide side);

/// Axes for orthographic_view(), seen from above: all three axes of the world are shortened alike (isometric), two of
/// them (dimetric, x half as long as y and z: 7 and 42 degrees of engineering drawings), or each by a factor of its own
/// (trimetric: the roots of 25, 34 and 41 fiftieths). From the south-west; `turn` turns the view counter-clockwise
/// about z.
enum class Axonometry { Isometric, Dimetric, Trimetric };
Basis axonometric_axes(Axonometry kind, Angle turn = {});

/// Parallel, but not at right angles to the view plane: what is a unit farther is shown `length` farther along `angle`
/// (counter-clockwise from right). Length 1: cavalier; 1/2: cabinet (Princeton: x + L cos a z, y + L sin a z). `length`
/// is 0 to 1.
ViewSpec oblique_view(const Vec3<World>& centre, const Basis& axes, View width, Unit length, Angle angle);

/// A view as PHIGS and the lab give it: a plane through the view reference point, a window in it, and a centre of
/// projection; all in world axes.
struct WindowView {
    Vec3<World> reference_point;
    Vec3<World> normal;  ///< VPN, of any length; either way, as it is the eye that says which way is ahead
    Vec3<World> up;      ///< VUP, of any length, not along the normal
    Vec3<World> centre_of_projection;
    World u_min, u_max, v_min, v_max;  ///< the window from the reference point: u right, v up
    std::optional<World> front, back;  ///< depths from the reference point, away from the eye; what is between is shown
    bool is_parallel = false;          ///< along the way from the centre of projection to the window's middle
};

/// u is VUP x VPN with a VPN toward the viewer, in right-handed axes (the lab's table; its text has no handedness). The
/// window is shown whole: on a screen of another shape with more around it. Throws InputError where the parts make no
/// view.
ViewSpec window_view(const WindowView& window);

/// Adds a plane at right angles to the view's forward, `distance` from a point: keeps what is beyond it (front), or
/// before it (back).
void cut_front(ViewSpec& view, const Vec3<World>& from, World distance);
void cut_back(ViewSpec& view, const Vec3<World>& from, World distance);
/// Keeps what is below this height: a section, as of a building without its roof.
void cut_above(ViewSpec& view, World height);

}  // namespace oblong

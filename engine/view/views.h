#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/view/screen.h"
#include "engine/view/view_context.h"

namespace oblong {

/// A plane that cuts off a part of the view: normal . p >= distance is kept.
struct ViewCut {
    Vec3<Unit> normal;  ///< of length 1
    PlaneDistance distance;
    bool operator==(const ViewCut&) const = default;
};

/// Any perspective or parallel view. The functions below make them.
struct ViewSpec {
    bool is_parallel = false;  ///< all rays have one direction, else they meet in the eye
    Vec3<World> eye;           ///< the centre of projection; in a parallel view a point shown in the middle
    Basis axes;                ///< at right angles; the view plane is parallel to right and up
    /// The middle of the screen is along forward + shear_x right + shear_y up: for off-centre windows and oblique
    /// projections. The length of both is at most kLargestShear.
    Unit shear_x, shear_y;
    ViewWindow window;          ///< in a parallel view the half width is in units
    std::vector<ViewCut> cuts;  ///< front and back planes, sections. There is no other near plane (frustum.h)
    bool operator==(const ViewSpec&) const = default;
};

/// One, plus a margin for rounding: with it no more products of world positions overflow than without shear.
inline constexpr Unit kLargestShear = Unit::from_raw((1 << 30) + 1024);
/// The largest coordinate of the eye of a sheared view.
inline constexpr World kFarthestShearedEye = World::from_int(1 << 18);
/// The largest and smallest width of a parallel view, units.
inline constexpr View kWidestParallel = View::from_int(1 << 20), kNarrowestParallel = View::from_int(1);

/// Why a view cannot be drawn in a mode, as a message; none if it can.
std::optional<std::string> problem_of(const ViewSpec& spec, const ScreenMode& mode);

/// The precision of a view, from Accuracy, and whether the projection corrects for pixel aspect.
struct ViewPrecision {
    std::int32_t matrix_bits = Unit::kFractionBits, view_bits = View::kFractionBits, subpixel_bits = 8;
    bool corrects_aspect = true;
};

/// `spec` has no problem_of().
ViewContext make_view_context(const ViewSpec& spec, const ScreenMode& mode, const ViewPrecision& precision = {});

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

/// A view as defined by PHIGS and the lab sheet L (tests/seeds): a plane through the view reference point, a window in
/// it, and a centre of projection; all in world axes.
struct WindowView {
    Vec3<World> reference_point;
    Vec3<World> normal;  ///< VPN, of any length and sign: forward is from the centre of projection to the plane
    Vec3<World> up;      ///< VUP, of any length, not along the normal
    Vec3<World> centre_of_projection;
    World u_min, u_max, v_min, v_max;  ///< the window, relative to the reference point: u right, v up
    std::optional<World> front, back;  ///< depths from the reference point, away from the eye; limits of the view
    bool is_parallel = false;          ///< along the line from the centre of projection to the window's middle
};

/// u is VUP x VPN with a VPN toward the viewer, in right-handed axes (the lab sheet's table; its text does not give the
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

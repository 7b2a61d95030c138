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

/// Any perspective or parallel view. view/views.h has functions that make them.
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

}  // namespace oblong

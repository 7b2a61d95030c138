#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/view/screen.h"
#include "engine/view/view_context.h"

namespace oblong {

/// A plane that cuts a part off what a view shows: normal . p >= distance is kept.
struct ViewCut {
    Vec3<Unit> normal;  ///< of length 1
    PlaneDistance distance;
    bool operator==(const ViewCut&) const = default;
};

/// Any view: where from, which way, how much of it, and how it gets onto a plane. Made by the functions of
/// view/views.h.
struct ViewSpec {
    bool is_parallel = false;  ///< all rays have one direction; else they meet in the eye
    Vec3<World> eye;           ///< the centre of projection; of a parallel view a point shown in the middle
    Basis axes;                ///< at right angles; the view plane is parallel to right and up
    /// The middle of the screen is seen along forward + shear_x right + shear_y up: what makes a window off-centre or a
    /// projection oblique. Together of a length up to kLargestShear.
    Unit shear_x, shear_y;
    ViewWindow window;          ///< of a parallel view its half width is in units
    std::vector<ViewCut> cuts;  ///< front and back planes, sections. There is no other near plane (frustum.h)
    bool operator==(const ViewSpec&) const = default;
};

/// One, and a little for rounding: with it no product of positions in the world overflows that does not without.
inline constexpr Unit kLargestShear = Unit::from_raw((1 << 30) + 1024);
/// How far the eye of a sheared view may be from the world's origin along each axis.
inline constexpr World kFarthestShearedEye = World::from_int(1 << 18);
/// A parallel view is so wide at most and at least, units.
inline constexpr View kWidestParallel = View::from_int(1 << 20), kNarrowestParallel = View::from_int(1);

/// What keeps a view from being drawn in a mode ("a window ..., expected ..."); none if it can be.
std::optional<std::string> problem_of(const ViewSpec& spec, const ScreenMode& mode);

/// How exactly a view is computed; from Accuracy, and whether the projection knows the shape of pixels.
struct ViewPrecision {
    std::int32_t matrix_bits = Unit::kFractionBits, view_bits = View::kFractionBits, subpixel_bits = 8;
    bool corrects_aspect = true;
};

/// All that transforms with a view need. The spec has no problem_of().
ViewContext make_view_context(const ViewSpec& spec, const ScreenMode& mode, const ViewPrecision& precision = {});

}  // namespace oblong

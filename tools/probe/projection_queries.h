#pragma once

#include <optional>

#include "engine/math/soft_float.h"
#include "engine/methods/axes.h"
#include "engine/view/project.h"

namespace oblong {

/// A point in viewspace with 62 significant bits.
using FarPoint = Vec3<SoftFloat>;

/// The multipliers of make_projection() with 62 significant bits.
struct FarProjection {
    SoftFloat x, y;
    ScreenWide centre_x, centre_y;
};

/// Any field of view above 0 and below 180 degrees, with all its bits: for a d of a million pixels, those of Degrees
/// are too few. `mode` as for make_projection().
FarProjection make_far_projection(const ScreenMode& mode, const SoftFloat& field_of_view_degrees);

/// A world point as seen from `world_eye`, within 2^-39 unit: to_view() with axes and products that are not rounded to
/// the frame's formats.
FarPoint to_far_view(const Vec3<World>& world_point, const Vec3<World>& world_eye, const FineBasis& basis);
/// The same point, converted exactly.
FarPoint to_far_view(const Vec3<View>& view_point);

/// The screen position of a point with z above 0, however far off the screen, by the formula of project(), with
/// relative errors of 2^-57. A frame clips such points and never projects them. None where 56 bits cannot hold the
/// position.
std::optional<ScreenPosition> project_far(const FarPoint& point, const FarProjection& projection);

/// Whether project() is exact to 1/200 pixel: the point is in view, for which the frame's formats are made, and not so
/// near that a step of View is more than 1/1,024 pixel.
bool is_exact_in_frame(const Vec3<View>& view_point, const Frustum& frustum, const Projection& projection);

}  // namespace oblong

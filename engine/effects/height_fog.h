#pragma once

#include <vector>

#include "engine/effects/fog.h"
#include "engine/math/vec.h"
#include "engine/view/view_directions.h"

namespace oblong {

/// Low fog (DarkPlaces): none above `top`, full density below top - fade_depth, linear between. A negative fade depth
/// counts as 0.
struct HeightFog {
    World top, fade_depth;
};

/// The same relative to an eye.
struct HeightFogView {
    View top_above_eye, fade_depth;
    View density_above_eye;              ///< the integral of the density from the top down to the eye
    LinearQuantity<DirectionPart> rise;  ///< a ray's climb for each unit of depth
};

HeightFogView make_height_fog_view(const HeightFog& fog, const Vec3<World>& eye, const ViewDirections& directions);

/// Whether a pixel at this depth is certainly clear, seen from above the fog.
bool is_clear(std::int32_t column, std::int32_t row, InverseZ inverse_z, const HeightFogView& view);
/// The same for every pixel of a rectangle on a plane. False if 1/z is not usable at the corners, which may be outside
/// the polygon.
bool is_clear(const ScreenRectangle& pixels, const LinearQuantity<InverseZ>& inverse_z, const HeightFogView& view);

/// Appends the runs of a span with linear 1/z, left to right, including clear ones. The level depends on the length of
/// the ray in fog, weighted by density: a ray wholly in full fog has the level of distance fog at its depth. Levels are
/// computed every 16 pixels; where two differ, bisection finds where they change. They are wrong only where a level
/// changes and changes back within 16 pixels.
void append_height_fog_runs(const Span& span, const LinearQuantity<InverseZ>& inverse_z, const HeightFogView& view,
                            const FogDepths& depths, std::vector<FogRun>& runs);

}  // namespace oblong

#pragma once

#include <vector>

#include "engine/effects/fog.h"
#include "engine/math/vec.h"
#include "engine/view/view_directions.h"

namespace oblong {

/// Fog that lies low (DarkPlaces): none above `top`, of full density below top - fade_depth, evenly denser between. A
/// fade depth below 0 counts as 0.
struct HeightFog {
    World top, fade_depth;
};

/// The same from an eye.
struct HeightFogView {
    View top_above_eye, fade_depth;
    View density_above_eye;              ///< the integral of the density from the top down to it
    LinearQuantity<DirectionPart> rise;  ///< how much a ray climbs for each unit of depth
};

HeightFogView make_height_fog_view(const HeightFog& fog, const Vec3<World>& eye, const ViewDirections& directions);

/// Whether what a pixel shows at this depth is surely clear, seen from above the fog.
bool is_clear(std::int32_t column, std::int32_t row, InverseZ inverse_z, const HeightFogView& view);
/// The same for every pixel of a rectangle on a plane. Where 1/z at its corners, perhaps outside of the polygon, says
/// nothing: false.
bool is_clear(const ScreenRectangle& pixels, const LinearQuantity<InverseZ>& inverse_z, const HeightFogView& view);

/// Appends the runs of a span along which 1/z is linear, left to right, clear ones too. Fog counts by the length of
/// the ray in it, each part by its density: a ray all of it in full fog has the level that distance fog has at its
/// depth. Levels are computed every 16 pixels, and where two of them differ, at as many between as it takes to find
/// where they change: they are wrong only where a level changes and changes back within 16 pixels.
void append_height_fog_runs(const Span& span, const LinearQuantity<InverseZ>& inverse_z, const HeightFogView& view,
                            const FogDepths& depths, std::vector<FogRun>& runs);

}  // namespace oblong

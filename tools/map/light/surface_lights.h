#pragma once

#include "tools/map/light/sources.h"
#include "tools/map/source/checks.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// Puts a light at the middle of each piece, at most kSurfacePiece units wide, of the surfaces that have the texture of
/// a light with the key "_surface", in that light's place; `offset` units over the surface. Into how many faces the
/// compiler cut a surface makes no difference. A texture that no face has is a warning, if that is not null.
void spread_surface_lights(std::vector<LightSource>& sources, const BspFile& bsp, Warnings* warnings);

inline constexpr double kSurfacePiece = 128;

}  // namespace oblong::map

#pragma once

#include "tools/map/light/sources.h"
#include "tools/map/source/checks.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// Replaces each light with the key "_surface": puts a light at the middle of each piece, at most kSurfacePiece units
/// wide, of the surfaces with this texture, `offset` units above the surface. The result does not depend on the number
/// of faces into which the compiler cut a surface. A texture without faces is a warning, if that is not null.
void spread_surface_lights(std::vector<LightSource>& sources, const BspFile& bsp, Warnings* warnings);

inline constexpr double kSurfacePiece = 128;

}  // namespace oblong::map

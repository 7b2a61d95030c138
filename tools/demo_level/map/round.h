#pragma once

#include "tools/demo_level/map/draft.h"

namespace oblong::map_source {

/// A sphere of 24 by 12 facets around `centre`, 112 * `scale` units across (a power of two), its facets of two textures
/// in turn.
Brush make_sphere(const Point& centre, double scale, const std::string& even_texture, const std::string& odd_texture);

/// A wall panel of 32 units' depth along y from `y_low`, square, 2 * `half` wide, with a round hole of 24 corners
/// and `radius` in its middle at (x, z).
void add_round_window(Draft& draft, double x, double z, double y_low, double half, double radius, const Skin& skin);

}  // namespace oblong::map_source

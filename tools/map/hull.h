#pragma once

#include "tools/map/brush.h"

namespace oblong::map {

/// The boxes that move through a level, around their origin: players, and large monsters.
inline constexpr Box kPlayerBox{{-16, -16, -24}, {16, 16, 32}};
inline constexpr Box kLargeBox{{-32, -32, -24}, {32, 32, 64}};

/// The brush grown by a box: all places of the box's origin where the box overlaps the brush (their Minkowski sum,
/// exactly: with the planes that bevel the brush's corners and edges).
Brush expanded(const Brush& brush, const Box& mover, PlaneList& planes);

/// What stops a mover: the solid, sky and clip brushes, grown, all as solid.
std::vector<Brush> hull_brushes(const std::vector<Brush>& brushes, const Box& mover, PlaneList& planes);

}  // namespace oblong::map

#pragma once

#include "game/input/controls.h"

namespace oblong {

/// A stick without its dead zone, a circle of `dead_zone_100` percent (0 to 90) of its way round the middle, in which
/// it is at rest: from there on it rises from 0, to the full length at 97 % of the way, which worn sticks still reach.
/// The direction stays.
Stick without_dead_zone(Stick stick, std::int32_t dead_zone_100);

/// Finer near the middle: as long as the square of its length, both as parts of the full one.
Stick squared(Stick stick);

}  // namespace oblong

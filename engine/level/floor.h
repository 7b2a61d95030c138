#pragma once

#include <optional>

#include "engine/level/level.h"

namespace oblong {

/// The floor of the world below a point.
struct Floor {
    PlaneIndex plane;
    Vec3<World> position;  ///< on the plane, straight below the point
};

/// The first solid of the world straight below `from`, at most `most` below it, through liquids. None from solid, above
/// a sky, or where the plane is steeper than 45 degrees. Brush models are no floor.
std::optional<Floor> find_floor(const Level& level, const Vec3<World>& from, World most);

}  // namespace oblong

#pragma once

#include <cstdint>

#include "engine/effects/sprites.h"

namespace oblong {

/// A sprite with a light that moves on a circle, counter-clockwise seen from above.
struct Lantern {
    Vec3<World> middle;             ///< of the circle
    World radius;                   ///< of the circle, >= 0
    std::int32_t period_ms = 1000;  ///< of a turn, above 0
    World light_radius;
    TextureIndex texture;
    World scale = World::from_int(1);  ///< of the sprite
};

/// The sprite at time_ms >= 0. The light is at the sprite's position.
Sprite lantern_at(const Lantern& lantern, std::int64_t time_ms);

}  // namespace oblong

#pragma once

#include <cstdint>

#include "engine/effects/sprites.h"

namespace oblong {

/// A sprite with a light that circles its place, counter-clockwise seen from above.
struct Lantern {
    Vec3<World> middle;             ///< of the circle
    World radius;                   ///< of the circle, 0 and more
    std::int32_t period_ms = 1000;  ///< of a turn, above 0
    World light_radius;
    TextureIndex texture;
    World scale = World::from_int(1);  ///< of the sprite
};

/// Its sprite at a time of 0 and more: a closed formula. The light is at the sprite's position.
Sprite lantern_at(const Lantern& lantern, std::int64_t time_ms);

}  // namespace oblong

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/effects/particles.h"
#include "engine/effects/shadows.h"
#include "engine/effects/sprites.h"
#include "engine/level/trace.h"
#include "engine/visibility/box_culler.h"

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

struct PlacedEmitter {
    ParticleEmitter emitter;
    PlacedBox place;
};

struct PlacedSprite {
    Sprite sprite;
    PlacedBox place;
    World shadow_radius;         ///< 0: no shadow
    std::optional<Floor> floor;  ///< of its shadow
};

struct PlacedLantern {
    Lantern lantern;
    PlacedBox place;  ///< around its circle
    PlacedBox lit;    ///< around the reach of its light
};

/// The entities of a level that are drawn in addition to faces: misc_rain, misc_dust, misc_sparks, air_bubbles;
/// misc_sprite; misc_lantern.
struct Things {
    std::vector<PlacedEmitter> emitters;
    std::vector<PlacedSprite> sprites;
    std::vector<PlacedLantern> lanterns;
    std::vector<std::string> warnings;  ///< errors in entities, and how they are handled

    bool is_empty() const { return emitters.empty() && sprites.empty() && lanterns.empty(); }
};

inline constexpr std::int32_t kMostParticles = 131'072;  ///< in a level; others are left out
inline constexpr std::size_t kMostEmitters = 1'024, kMostSprites = 4'096, kMostLanterns = 64;

/// A box of places, enlarged by 8 units, as things are drawn around their places.
LevelBox box_between(const Vec3<World>& mins, const Vec3<World>& maxs);

/// Reads the things of a level. Never fails: invalid values are replaced by defaults and reported in `warnings`.
Things read_things(const Level& level);

}  // namespace oblong

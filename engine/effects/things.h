#pragma once

#include <string>
#include <vector>

#include "engine/effects/lanterns.h"
#include "engine/effects/particles.h"
#include "engine/effects/sprites.h"
#include "engine/level/trace.h"
#include "engine/visibility/placed_box.h"

namespace oblong {

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

/// Reads the things of a level. Never fails: invalid values are replaced by defaults and reported in `warnings`.
Things read_things(const Level& level);

}  // namespace oblong

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
    std::optional<Floor> floor;  ///< where its shadow falls
};

struct PlacedLantern {
    Lantern lantern;
    PlacedBox place;  ///< of its whole circle
    PlacedBox lit;    ///< of what its light may reach
};

/// What a level's entities put into it in addition to its faces: misc_rain, misc_dust, misc_sparks, air_bubbles;
/// misc_sprite; misc_lantern.
struct Things {
    std::vector<PlacedEmitter> emitters;
    std::vector<PlacedSprite> sprites;
    std::vector<PlacedLantern> lanterns;
    std::vector<std::string> warnings;  ///< what is wrong with them, and what is done about it

    bool is_empty() const { return emitters.empty() && sprites.empty() && lanterns.empty(); }
};

inline constexpr std::int32_t kMostParticles = 131'072;  ///< of a level: further ones are left out
inline constexpr std::size_t kMostEmitters = 1'024, kMostSprites = 4'096, kMostLanterns = 64;

/// Reads the things of a level. Never fails: bad values are replaced by defaults, and reported in `warnings`.
Things read_things(const Level& level);

}  // namespace oblong

#pragma once

#include <cstdint>
#include <vector>

#include "engine/effects/sight.h"
#include "engine/effects/things.h"
#include "engine/raster/depth.h"

namespace oblong {

/// The things in a visible set, kept until the eye is in another leaf: no others are looked at.
struct ThingsInSet {
    std::vector<const PlacedEmitter*> emitters;
    std::vector<const PlacedSprite*> sprites;
    std::vector<const PlacedLantern*> lanterns;

    /// `things` must outlive it.
    void keep_up(const Things& things, const VisibleSet& visible);

  private:
    LeafIndex from_ = LeafIndex::none();
};

struct SpriteInView {
    ScreenSprite screen;
    Vec3<World> position;
};

/// The dots of one emitter.
struct EmitterInView {
    std::size_t first_dot = 0, dot_count = 0;  ///< in ThingsInView::dots
    Vec3<World> middle;
    World lowest_z;  ///< of their box
};

/// The things that may be visible in a frame. Kept from frame to frame to save allocations.
struct ThingsInView {
    std::vector<ParticleDot> dots;
    std::vector<EmitterInView> emitters;              ///< those with dots
    std::vector<const PlacedSprite*> placed_sprites;  ///< whose box, which holds the shadow, may be visible
    std::vector<SpriteInView> sprites;
    std::vector<Shadow> shadows;
    std::int64_t particles_computed = 0;  ///< where they may be visible; includes those out of view

    void clear() {
        dots.clear();
        emitters.clear();
        placed_sprites.clear();
        sprites.clear();
        shadows.clear();
        particles_computed = 0;
    }
};

// Each adds the things that may be visible at time_ms >= 0, and requests depth for them. Things whose box is out of
// view, in no leaf of the visible set, or hidden are not computed.

void find_particles(const ThingsInSet& things, std::int64_t time_ms, const Sight& sight, ThingsInView& in_view,
                    DepthBuffer& depth);
/// Before find_sprites() and find_shadows().
void find_placed_sprites(const ThingsInSet& things, const Sight& sight, ThingsInView& in_view);
/// Including those of lanterns.
void find_sprites(const ThingsInSet& things, std::int64_t time_ms, const Level& level, const Sight& sight,
                  ThingsInView& in_view, DepthBuffer& depth);
/// Shadows need no depth.
void find_shadows(ThingsInView& in_view);

}  // namespace oblong

#pragma once

#include <vector>

#include "engine/effects/particle_dots.h"
#include "engine/effects/shadows.h"
#include "engine/effects/sprites.h"
#include "engine/surface/colormap.h"

namespace oblong {

struct FrameContext;
struct FrameFog;
class FrameWorkspace;

/// The dots of one emitter that a frame shows, or one sprite.
struct FoundThing {
    Vec3<World> middle;                          ///< of the emitter's box or the sprite
    std::uint32_t first_dot = 0, dot_count = 0;  ///< in FrameThings::dots
    std::optional<ScreenSprite> sprite;
    const std::uint8_t* colours = nullptr;  ///< of the sprite: 256 of them
};

/// What is drawn into a frame beside its faces.
struct FrameThings {
    std::vector<ParticleDot> dots;
    std::vector<FoundThing> found;
    std::vector<Shadow> shadows;
};

/// Finds the particles, sprites and shadows that own pixels of the frame whose faces are claimed: what is in view, and
/// not wholly behind faces.
void find_things(const FrameContext& frame, const FrameFog& fog, FrameWorkspace& work);

/// Draws one of them where no face is nearer.
void draw_thing(const FoundThing& thing, const FrameContext& frame, FrameWorkspace& work);

/// Darkens the pixels of floors that shadows fall on.
void draw_shadows(const FrameContext& frame, FrameWorkspace& work);

}  // namespace oblong

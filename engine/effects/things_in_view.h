#pragma once

#include <cstdint>
#include <vector>

#include "engine/effects/particle_dots.h"
#include "engine/effects/shadows.h"
#include "engine/effects/sprites.h"
#include "engine/effects/things.h"
#include "engine/raster/depth.h"

namespace oblong {

struct SpriteInView {
    ScreenSprite screen;
    Vec3<World> position;
};

/// The dots of one emitter.
struct EmitterInView {
    std::size_t first_dot = 0, dot_count = 0;  ///< in ThingsInView::dots
    Vec3<World> middle;
    World lowest;  ///< z of their box
};

/// The things of a frame that may be seen. Kept from frame to frame, so that little is allocated.
struct ThingsInView {
    std::vector<ParticleDot> dots;
    std::vector<EmitterInView> emitters;  ///< those with dots
    std::vector<SpriteInView> sprites;
    std::vector<Shadow> shadows;
    std::int64_t particles_computed = 0;  ///< of emitters that may be seen, in view or not

    void clear() {
        dots.clear();
        emitters.clear();
        sprites.clear();
        shadows.clear();
        particles_computed = 0;
    }
};

/// Tells what faces hide.
class Cover {
  public:
    virtual ~Cover() = default;
    /// Whether all of what stays in a box is surely hidden.
    virtual bool hides(const LevelBox& box) = 0;
    /// Whether each pixel of a rectangle shows a face that is nearer than this depth.
    virtual bool hides(const ScreenRectangle& pixels, InverseDepth nearest) = 0;
};

/// What a frame sees from where.
struct Sight {
    const LeafSet& leaves;  ///< what is in none of them is not seen
    const ViewContext& view;
    const ScreenRectangle* part = nullptr;  ///< of the screen that is drawn; null: all of it
    Cover* cover = nullptr;                 ///< null: none
    BoxCuller culler{view.frustum, view.eye};

    bool may_show(const PlacedBox& place) const {
        return may_be_seen(place, leaves, culler) && !(cover && cover->hides(place.box));
    }
    bool may_show(const LevelBox& box) const {
        return culler.planes_crossed(box, kAllSides) != kOutside && !(cover && cover->hides(box));
    }
    bool may_show(const ScreenRectangle& pixels, InverseDepth nearest) const {
        return !(cover && cover->hides(pixels, nearest));
    }
};

// Each adds those things that may be seen at a time of 0 and more, and wants depth where they are. Those whose place is
// out of view, in no leaf of the visible set, or covered, are not computed at all.

void find_particles(const Things& things, std::int64_t time_ms, const Sight& sight, ThingsInView& in_view,
                    DepthBuffer& depth);
/// Those of lanterns too.
void find_sprites(const Things& things, std::int64_t time_ms, const Level& level, const Sight& sight,
                  ThingsInView& in_view, DepthBuffer& depth);
/// They need no depth.
void find_shadows(const Things& things, const Sight& sight, ThingsInView& in_view);

}  // namespace oblong

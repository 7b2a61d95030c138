#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/effects/particles.h"
#include "engine/effects/shadows.h"
#include "engine/effects/sprites.h"
#include "engine/level/trace.h"
#include "engine/raster/depth.h"
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

/// Reads the things of a level. Never fails: invalid values are replaced by defaults and reported in `warnings`.
Things read_things(const Level& level);

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

/// Where a thing is known to be hidden: nowhere; everywhere but over the sky, which hides nothing; or everywhere.
enum class Hidden : std::uint8_t { Perhaps, ExceptOverSky, Everywhere };

/// What faces leave open to a thing.
class Cover {
  public:
    virtual ~Cover() = default;
    /// Begins a thing: whether at a pixel of a rectangle that holds it no face is nearer than this depth.
    virtual bool begin(const ScreenRectangle& pixels, InverseDepth nearest, Hidden hidden) = 0;
    /// The same of a part of the thing, which is nowhere nearer and not outside the rectangle.
    virtual bool shows(const ScreenOutline& outline, InverseDepth nearest) const = 0;
    /// The same; later questions are only of what is inside the outline and not nearer. Takes longer.
    virtual bool narrow(const ScreenOutline& outline, InverseDepth nearest) = 0;
};

/// The visibility tests of a frame.
struct Sight {
    const LeafSet& leaves;  ///< things in none of them are not visible
    const ViewContext& view;
    const ScreenRectangle* drawn_part = nullptr;  ///< the part of the screen that is drawn; null: all
    Cover* cover = nullptr;                       ///< or null
    /// More leaves, or null: a thing in one of these, but in none of `leaves`, is visible in front of the sky alone.
    const LeafSet* leaves_over_sky = nullptr;
    BoxCuller culler{view.frustum, view.eye};

    Hidden hidden(const PlacedBox& place) const {
        if (culler.sides_crossed(place.box, kAllSides) == kOutside) return Hidden::Everywhere;
        if (reaches(place, leaves)) return Hidden::Perhaps;
        return leaves_over_sky && reaches(place, *leaves_over_sky) ? Hidden::ExceptOverSky : Hidden::Everywhere;
    }
    /// Begins a thing in a box.
    bool may_show(const PlacedBox& place) const {
        const Hidden found = hidden(place);
        return found != Hidden::Everywhere &&
               may_show(rectangle_of(place.box, view), nearest_inverse_depth_of(place.box, view), found);
    }
    /// Begins a thing in a rectangle.
    bool may_show(const ScreenRectangle& pixels, InverseDepth nearest, Hidden hidden = Hidden::Perhaps) const {
        return !cover || cover->begin(pixels, nearest, hidden);
    }
    // Of a part of the thing begun last.
    bool may_show_part(const LevelBox& box) const {
        if (culler.sides_crossed(box, kAllSides) == kOutside) return false;
        const InverseDepth nearest = nearest_inverse_depth_of(box, view);
        return may_show_part(rectangle_of(box, view), nearest) &&
               (!cover || cover->shows(outline_of(box, view), nearest));
    }
    bool may_show_part(const ScreenOutline& outline, InverseDepth nearest) const {
        return !cover || cover->shows(outline, nearest);
    }
    bool may_show_part(const ScreenRectangle& pixels, InverseDepth nearest) const {
        return may_show_part(ScreenOutline{pixels}, nearest);
    }
    /// The same; the later questions are of this part.
    bool narrow(const LevelBox& box) const {
        return !cover || cover->narrow(outline_of(box, view), nearest_inverse_depth_of(box, view));
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

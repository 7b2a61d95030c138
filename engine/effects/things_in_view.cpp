#include "engine/effects/things_in_view.h"

#include <algorithm>
#include <optional>
#include <span>

namespace oblong {
namespace {

/// Removes the dots from `first` on that are outside the part of the screen that is drawn.
void keep_dots_in(const ScreenRectangle& part, std::size_t first, std::vector<ParticleDot>& dots) {
    const auto is_outside = [&part](const ParticleDot& dot) {
        return !overlap({dot.first_column, dot.end_column, dot.first_row, dot.end_row}, part);
    };
    dots.erase(std::remove_if(dots.begin() + static_cast<std::ptrdiff_t>(first), dots.end(), is_outside), dots.end());
}

/// Whether the particles whose places are in a box may show.
bool may_show(const ParticleBox& places, const Sight& sight) {
    return sight.may_show_part(box_between(places.mins, places.maxs));
}

/// Drops quarters of a box from its bottom and its top, up to five times, as long as particles there are hidden.
void drop_hidden_ends(ParticleBox& places, const Sight& sight) {
    for (int cut = 0; cut < 5; ++cut) {
        const World quarter = (places.maxs.z - places.mins.z) / 4;
        ParticleBox low = places, high = places;
        low.maxs.z = places.mins.z + quarter;
        high.mins.z = places.maxs.z - quarter;
        const bool is_low_open = may_show(low, sight), is_high_open = may_show(high, sight);
        if (!is_low_open) places.mins.z = low.maxs.z;
        if (!is_high_open) places.maxs.z = high.mins.z;
        if (is_low_open && is_high_open) break;
    }
}

/// Where particles of the emitter begun last may show; none: nowhere. A few cost less than these tests.
std::optional<ParticleBox> open_places(const ParticleEmitter& emitter, const Sight& sight) {
    constexpr std::int32_t kFewParticles = 100;
    ParticleBox places = box_of(emitter);
    if (emitter.count < kFewParticles) return places;
    drop_hidden_ends(places, sight);
    if (!sight.narrow(box_between(places.mins, places.maxs))) return std::nullopt;
    for (int column = 0; column < ParticleBox::kColumns; ++column)
        if (!may_show(places.column(column), sight)) places.columns &= ~(1u << column);
    if (places.columns == 0) return std::nullopt;
    return places;
}

/// Whether a pixel of some dots is not hidden.
bool may_show_any(std::span<const ParticleDot> dots, const Sight& sight) {
    return std::any_of(dots.begin(), dots.end(), [&sight](const ParticleDot& dot) {
        return sight.may_show_part(ScreenRectangle{dot.first_column, dot.end_column, dot.first_row, dot.end_row},
                                   dot.inverse_depth);
    });
}

void add_sprite(const Sprite& sprite, const Level& level, const Sight& sight, ThingsInView& in_view,
                DepthBuffer& depth) {
    const std::optional<ScreenSprite> screen = project_sprite(sprite, level.textures[sprite.texture], sight.view);
    if (!screen || (sight.drawn_part && !overlap(screen->pixels, *sight.drawn_part))) return;
    if (!sight.may_show(screen->pixels, middle_inverse_depth(*screen))) return;
    in_view.sprites.push_back({*screen, sprite.position});
    depth.want(screen->pixels);
}

}  // namespace

void ThingsInSet::keep_up(const Things& things, const VisibleSet& visible) {
    if (visible.seen_from() == from_) return;
    from_ = visible.seen_from();
    const auto take = [&visible](const auto& placed, auto& in_set) {
        in_set.clear();
        in_set.reserve(placed.size());
        for (const auto& one : placed)
            if (reaches(one.place, visible.leaf_set())) in_set.push_back(&one);
    };
    take(things.emitters, emitters);
    take(things.sprites, sprites);
    take(things.lanterns, lanterns);
}

void find_particles(const ThingsInSet& things, std::int64_t time_ms, const Sight& sight, ThingsInView& in_view,
                    DepthBuffer& depth) {
    for (const PlacedEmitter* const known : things.emitters) {
        const PlacedEmitter& placed = *known;
        if (!sight.may_show(placed.place)) continue;
        const std::optional<ParticleBox> places = open_places(placed.emitter, sight);
        if (!places) continue;
        const std::size_t first = in_view.dots.size();
        in_view.particles_computed += append_dots(placed.emitter, time_ms, sight.view, *places, in_view.dots);
        if (sight.drawn_part) keep_dots_in(*sight.drawn_part, first, in_view.dots);
        const std::span<const ParticleDot> dots = std::span(in_view.dots).subspan(first);
        if (!may_show_any(dots, sight)) {
            in_view.dots.resize(first);
            continue;
        }
        in_view.emitters.push_back(
            {first, dots.size(), placed.emitter.middle, World::from_int(placed.place.box.mins[2])});
        depth.want(rectangle_around(dots));
    }
}

void find_placed_sprites(const ThingsInSet& things, const Sight& sight, ThingsInView& in_view) {
    for (const PlacedSprite* const placed : things.sprites)
        if (sight.may_show(placed->place)) in_view.placed_sprites.push_back(placed);
}

void find_sprites(const ThingsInSet& things, std::int64_t time_ms, const Level& level, const Sight& sight,
                  ThingsInView& in_view, DepthBuffer& depth) {
    for (const PlacedSprite* const placed : in_view.placed_sprites)
        add_sprite(placed->sprite, level, sight, in_view, depth);
    for (const PlacedLantern* const placed : things.lanterns)
        if (sight.may_show(placed->place))
            add_sprite(lantern_at(placed->lantern, time_ms), level, sight, in_view, depth);
}

void find_shadows(ThingsInView& in_view) {
    for (const PlacedSprite* const placed : in_view.placed_sprites)
        if (placed->floor)
            in_view.shadows.push_back(make_shadow(*placed->floor, placed->sprite.position, placed->shadow_radius));
}

}  // namespace oblong

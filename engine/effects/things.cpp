#include "engine/effects/things.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "engine/effects/entity_values.h"
#include "engine/effects/shadows.h"
#include "engine/fixed/arithmetic.h"
#include "engine/fixed/trig.h"
#include "engine/level/entities.h"
#include "engine/level/entity_classes.h"
#include "engine/scene/placed_models.h"

namespace oblong {
namespace {

/// A box of places, enlarged by 8 units, as things are drawn around their places.
LevelBox box_between(const Vec3<World>& mins, const Vec3<World>& maxs) {
    const std::array low{mins.x, mins.y, mins.z}, high{maxs.x, maxs.y, maxs.z};
    LevelBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.mins[axis] = box_coordinate(floor_of(low[axis]) - 8);
        box.maxs[axis] = box_coordinate(floor_of(high[axis]) + 9);
    }
    return box;
}

LevelBox box_around(const Vec3<World>& middle, const Vec3<World>& half_size) {
    return box_between(middle - half_size, middle + half_size);
}

LevelBox box_around_both(LevelBox box, const LevelBox& other) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.mins[axis] = std::min(box.mins[axis], other.mins[axis]);
        box.maxs[axis] = std::max(box.maxs[axis], other.maxs[axis]);
    }
    return box;
}

class ThingReader {
  public:
    explicit ThingReader(const Level& level) : level_(level) {}

    Things read() {
        for (std::size_t i = 0; i < level_.entities.size(); ++i) read(level_.entities[i], i);
        return std::move(things_);
    }

  private:
    /// Quake adds the origin to the place of the brushes.
    void warn_of_moved_brushes(const Entity& entity, const EntityValues& values) {
        const ClassRole role = role_of(entity);
        const std::string origin = values.text("origin");
        const bool is_ignored = role != ClassRole::Rotating && role != ClassRole::TurningDoor && !origin.empty();
        if (is_ignored && brush_model_of(entity, level_) && parse_world_vector(origin) != Vec3<World>{})
            values.warn("origin is \"" + origin +
                        "\", expected none with brushes: they stay where they are in the level");
    }

    void read(const Entity& entity, std::size_t index) {
        const EntityValues values(entity, index, things_.warnings);
        if (values.text("model").starts_with('*') && !brush_model_of(entity, level_))
            values.warn("model is \"" + values.text("model") + "\", expected one of the level's " +
                        std::to_string(level_.models.count() - 1) + " brush models: its brushes are left out");
        warn_of_moved_brushes(entity, values);
        switch (role_of(entity)) {
            case ClassRole::Rain:
                return read_emitter(ParticleKind::Rain, values, index);
            case ClassRole::Dust:
                return read_emitter(ParticleKind::Dust, values, index);
            case ClassRole::Sparks:
                return read_emitter(ParticleKind::Sparks, values, index);
            case ClassRole::Bubbles:
                return read_emitter(ParticleKind::Bubbles, values, index);
            case ClassRole::Billboard:
                return read_sprite(values);
            case ClassRole::FlyingLamp:
                return read_lantern(values);
            default:
                return;
        }
    }

    void read_emitter(ParticleKind kind, const EntityValues& values, std::size_t index) {
        const std::optional<Vec3<World>> origin = values.origin();
        if (!origin || !has_room(things_.emitters.size(), kMostEmitters, values)) return;
        constexpr World kLeastSize = World::from_int(1), kMostSize = World::from_int(65536);
        const std::optional<Vec3<World>> size = values.vector("size", kLeastSize, kMostSize);
        ParticleEmitter emitter;
        emitter.kind = kind;
        emitter.half_size = {size->x / 2, size->y / 2, size->z / 2};
        emitter.middle = *origin;
        // Quake's air_bubbles has no size: bubbles rise from its origin.
        if (emitter.kind == ParticleKind::Bubbles && values.text("size").empty())
            emitter.middle.z += emitter.half_size.z;
        emitter.period_ms = values.period_ms();
        emitter.count = particles_left(values.whole_number("count", 0, kMostParticles), values);
        emitter.seed = static_cast<std::uint32_t>(index);
        const ColourRamp ramp = values.colours("colour");
        emitter.first_colour = ramp.first;
        emitter.last_colour = ramp.last;
        if (emitter.count == 0) return;
        things_.emitters.push_back({emitter, place_box(level_, box_around(emitter.middle, emitter.half_size))});
    }

    void read_sprite(const EntityValues& values) {
        const std::optional<Vec3<World>> origin = values.origin();
        const TextureIndex texture = texture_of(values);
        if (!origin || texture.is_none() || !has_room(things_.sprites.size(), kMostSprites, values)) return;
        PlacedSprite placed;
        placed.sprite = {*origin, texture, scale_of(values)};
        placed.shadow_radius = values.number("shadow", {World{}, World::from_int(512)});
        if (placed.shadow_radius > World{}) placed.floor = find_floor(level_, *origin, kFarthestShadow);
        LevelBox box = box_around(*origin, half_size_of(placed.sprite));
        if (placed.floor) {
            const World radius = placed.shadow_radius;  // the floor's slope is at most 1
            box = box_around_both(box, box_around(placed.floor->position, {radius, radius, radius}));
        }
        placed.place = place_box(level_, box);
        things_.sprites.push_back(std::move(placed));
    }

    void read_lantern(const EntityValues& values) {
        const std::optional<Vec3<World>> origin = values.origin();
        const TextureIndex texture = texture_of(values);
        if (!origin || texture.is_none() || !has_room(things_.lanterns.size(), kMostLanterns, values)) return;
        Lantern lantern;
        lantern.middle = *origin;
        lantern.texture = texture;
        lantern.scale = scale_of(values);
        lantern.radius = values.number("radius", {World{}, World::from_int(4096)});
        lantern.light_radius = values.number("light", {World{}, World::from_int(2048)});
        lantern.period_ms = values.period_ms();
        const Vec3<World> half = half_size_of({*origin, texture, lantern.scale});
        const Vec3<World> reach = half + Vec3<World>{lantern.radius, lantern.radius, {}};
        const World light = lantern.radius + lantern.light_radius;
        things_.lanterns.push_back({lantern, place_box(level_, box_around(*origin, reach)),
                                    place_box(level_, box_around(*origin, {light, light, lantern.light_radius}))});
    }

    /// `count`, reduced to the level's limit.
    std::int32_t particles_left(std::int32_t count, const EntityValues& values) {
        const std::int32_t left = std::min(count, kMostParticles - particle_count_);
        if (left < count)
            values.warn("the level has more than " + std::to_string(kMostParticles) +
                        " particles: " + std::to_string(left) + " of " + std::to_string(count) + " are kept");
        particle_count_ += left;
        return left;
    }

    static bool has_room(std::size_t count, std::size_t most, const EntityValues& values) {
        if (count < most) return true;
        values.warn("the level has more than " + std::to_string(most) + " of its kind: it is left out");
        return false;
    }

    TextureIndex texture_of(const EntityValues& values) const {
        const std::string name = values.text("texture");
        for (const TextureIndex index : level_.textures.indices())
            if (level_.textures[index].name == name) return index;
        values.warn("texture is \"" + name + "\", expected one of the level's: it is left out");
        return TextureIndex::none();
    }

    static World scale_of(const EntityValues& values) {
        return values.number("scale", {World::from_raw(4096 / 16), World::from_int(16)});
    }

    /// The width counts in both horizontal directions, as the sprite turns.
    Vec3<World> half_size_of(const Sprite& sprite) const {
        const MipTexture& texture = level_.textures[sprite.texture];
        const auto half = [&](std::int32_t texels) {
            const WorldWide size = convert<WorldWide>(sprite.scale) * texels;
            return convert<World>(std::min(size / 2, WorldWide::from_int(65536)));
        };
        return {half(texture.width), half(texture.width), half(texture.height)};
    }

    const Level& level_;
    Things things_;
    std::int32_t particle_count_ = 0;
};

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

Things read_things(const Level& level) {
    return ThingReader(level).read();
}

Sprite lantern_at(const Lantern& lantern, std::int64_t time_ms) {
    const Angle angle = Angle::from_bam(time_ms % lantern.period_ms * 65536 / lantern.period_ms);
    const Vec3<World> from_middle{
        product<World>(lantern.radius, cosine(angle)), product<World>(lantern.radius, sine(angle)), {}};
    return {lantern.middle + from_middle, lantern.texture, lantern.scale};
}

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

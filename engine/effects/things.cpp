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

LevelBox box_between(const Vec3<World>& mins, const Vec3<World>& maxs) {
    const std::array low{mins.x, mins.y, mins.z}, high{maxs.x, maxs.y, maxs.z};
    LevelBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.mins[axis] = box_coordinate(floor_of(low[axis]) - 8);
        box.maxs[axis] = box_coordinate(floor_of(high[axis]) + 9);
    }
    return box;
}

namespace {

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
        const std::optional<Vec3<World>> size = values.vector("size");
        ParticleEmitter emitter;
        emitter.kind = kind;
        emitter.half_size = {size->x / 2, size->y / 2, size->z / 2};
        emitter.middle = *origin;
        // Quake's air_bubbles has no size: bubbles rise from its origin.
        if (emitter.kind == ParticleKind::Bubbles && values.text("size").empty())
            emitter.middle.z += emitter.half_size.z;
        emitter.period_ms = values.period_ms();
        emitter.count = particles_left(values.whole_number("count"), values);
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
        placed.shadow_radius = values.number("shadow");
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
        lantern.radius = values.number("radius");
        lantern.light_radius = values.number("light");
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

    static World scale_of(const EntityValues& values) { return values.number("scale"); }

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

}  // namespace oblong

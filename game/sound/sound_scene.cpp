#include "game/sound/sound_scene.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/effects/things.h"
#include "engine/level/entities.h"
#include "engine/level/entity_classes.h"
#include "engine/scene/level_effects.h"

namespace oblong {
namespace {

// Faces with the same sound in a cube of this size become one source.
constexpr std::int32_t kCell = 256;

std::optional<Sound> sound_of_face(const Level& level, const Face& face) {
    const std::string_view texture = level.texture_of(face).name;
    constexpr std::array kLiquids{Sound::Water, Sound::Slime, Sound::Lava, Sound::Teleporter};  // by LiquidKind
    if (texture.starts_with('*')) return item(kLiquids, liquid_kind_of_texture(texture));
    if (level.texinfos[face.texinfo].material == Material::Sky) return Sound::Wind;
    if (texture == "lamp" || texture == "lamp_blue" || texture == "neon" || texture.starts_with("+0volt"))
        return Sound::Hum;
    return {};
}

Box box_of_face(const Level& level, const Face& face) {
    std::optional<Box> box;
    for (const SurfEdge step : level.edges_of(face)) {
        const Vec3<World>& corner = level.vertices[level.start_of(step)];
        box = box ? box->united({corner, corner}) : Box{corner, corner};
    }
    return box.value_or(Box{});
}

class SourceList {
  public:
    // Splits a box into parts of at most a cell each: one box around an L-shaped canal would sound where there is no
    // water.
    void add(Sound sound, const Box& box) {
        for (std::int32_t x = cell_of(box.mins.x); x <= cell_of(box.maxs.x); ++x)
            for (std::int32_t y = cell_of(box.mins.y); y <= cell_of(box.maxs.y); ++y)
                for (std::int32_t z = cell_of(box.mins.z); z <= cell_of(box.maxs.z); ++z) add_part(sound, box, x, y, z);
    }
    std::vector<SoundSource> sources() const {
        std::vector<SoundSource> list;
        for (const auto& [key, box] : cells_) {
            SoundSource source;
            source.sound = std::get<0>(key);
            source.box = box;
            list.push_back(source);
        }
        return list;
    }

  private:
    using Key = std::tuple<Sound, std::int32_t, std::int32_t, std::int32_t>;

    static std::int32_t cell_of(World coordinate) { return floor_of(coordinate) >> 8; }
    void add_part(Sound sound, const Box& box, std::int32_t x, std::int32_t y, std::int32_t z) {
        const Box cell{world_vector(x * kCell, y * kCell, z * kCell),
                       world_vector((x + 1) * kCell, (y + 1) * kCell, (z + 1) * kCell)};
        const Box part{
            {std::max(box.mins.x, cell.mins.x), std::max(box.mins.y, cell.mins.y), std::max(box.mins.z, cell.mins.z)},
            {std::min(box.maxs.x, cell.maxs.x), std::min(box.maxs.y, cell.maxs.y), std::min(box.maxs.z, cell.maxs.z)}};
        const auto [place, is_new] = cells_.try_emplace({sound, x, y, z}, part);
        if (!is_new) place->second = place->second.united(part);
    }

    std::map<Key, Box> cells_;
};

void add_faces(const Level& level, SourceList& list) {
    for (const FaceIndex index : level.world().faces) {
        const Face& face = level.faces[index];
        if (const auto sound = sound_of_face(level, face)) list.add(*sound, box_of_face(level, face));
    }
}

void add_emitters(const Level& level, SourceList& list) {
    for (const PlacedEmitter& placed : read_things(level).emitters) {
        const ParticleEmitter& emitter = placed.emitter;
        const Box box{emitter.middle - emitter.half_size, emitter.middle + emitter.half_size};
        if (emitter.kind == ParticleKind::Rain) list.add(Sound::Rain, box);
        if (emitter.kind == ParticleKind::Sparks) list.add(Sound::Sparks, box);
        if (emitter.kind == ParticleKind::Bubbles) list.add(Sound::Bubbles, box);
    }
}

void add_entities(const Level& level, SourceList& list) {
    for (const Entity& entity : level.entities) {
        const EntityClass* const its_class = find_entity_class(entity.value("classname"));
        const auto sound = its_class ? find_sound(its_class->sound) : std::nullopt;
        const auto place = parse_world_vector(entity.value("origin"));
        if (sound && place) list.add(*sound, {*place, *place});
    }
}

}  // namespace

Ambience::Ambience(const Level& level) {
    SourceList list;
    add_faces(level, list);
    add_emitters(level, list);
    add_entities(level, list);
    sources_ = list.sources();
    std::vector<BoxTree::Entry> entries;
    for (const SoundSource& source : sources_) {
        const std::int32_t range = row_of(source.sound).range;
        entries.push_back(
            {source.box.grown(world_vector(range, range, range)), static_cast<std::uint32_t>(entries.size())});
    }
    heard_in_ = BoxTree(std::move(entries));
}

void Ambience::collect(const Position& ear, std::vector<SoundSource>& sources) const {
    for (const std::uint32_t i : heard_in_.overlapping({ear, ear})) sources.push_back(sources_[i]);
}

SoundScene::SoundScene(const GameLevel& level, const LevelSounds* own)
    : level_(level), own_(own), ambience_(*level.bsp), starts_(level, own) {}

std::int32_t SoundScene::length_ticks(const SoundSource& source) const {
    if (source.own == LevelSounds::kNone) return row_of(source.sound).length_ticks;
    const SoundSamples& samples = item(own_->sounds, source.own).samples;
    const std::int64_t ticks = std::ssize(samples.samples) * kTicksPerSecond / samples.rate_hz + 1;
    return static_cast<std::int32_t>(std::min<std::int64_t>(ticks, std::numeric_limits<std::int32_t>::max()));
}

void SoundScene::note_tick(const GameState& before, const GameState& after, const TickReport& report, bool is_last) {
    std::vector<SoundSource> sources;
    starts_.note_tick(before, after, report, sources);
    for (const SoundSource& source : sources)
        if (source.serial != 0) one_shots_.push_back({source, length_ticks(source)});
    std::erase_if(sources, [](const SoundSource& source) { return source.serial != 0; });
    if (is_last) hear(after, std::move(sources));
    std::erase_if(one_shots_, [](OneShot& one_shot) { return --one_shot.ticks_left <= 0; });
}

void SoundScene::hear(const GameState& state, std::vector<SoundSource> sources) {
    const Listener listener = listener_of(state.player);
    for (const OneShot& one_shot : one_shots_) sources.push_back(one_shot.source);
    ambience_.collect(listener.ear, sources);
    if (listener.is_under_water) {
        SoundSource source;
        source.sound = Sound::UnderWater;
        sources.push_back(source);
    }
    heard_from_.start();
    audible_ = audible_sounds(level_, state, listener, sources, heard_from_);
    keep_heard();
}

// A one-shot that is not in range at its start, or leaves it, is not resumed.
void SoundScene::keep_heard() {
    std::erase_if(one_shots_, [&](OneShot& one_shot) {
        return std::none_of(audible_.sounds.begin(), audible_.sounds.end(),
                            [&](const AudibleSound& sound) { return sound.serial == one_shot.source.serial; });
    });
}

}  // namespace oblong

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string>

#include "engine/base/text.h"
#include "engine/level/entity_classes.h"
#include "engine/scene/pick.h"
#include "game/simulation/step.h"
#include "game/sound/sound_scene.h"

namespace oblong {
namespace {

constexpr std::int32_t kStandard = LevelSounds::kNone;
constexpr World kStride = World::from_int(104), kStroke = World::from_int(170);
constexpr World kHardLanding = World::from_int(-330);  // units a second
const Vec3<World> kTouching = world_vector(24, 24, 24);

bool stands(const Player& player) {
    return player.ground != Player::kNoGround;
}
bool swims(const Player& player) {
    return player.depth >= Depth::Waist;
}

Vec3<World> offset_in(const GameLevel& level, const GameState& state, std::uint32_t mover) {
    return offset_of(level.movers[mover], state.movers[mover]);
}

bool has_moved(const GameLevel& level, std::uint32_t mover, const GameState& before, const GameState& after) {
    if (level.movers[mover].turns != 0) return before.movers[mover].travelled != after.movers[mover].travelled;
    return offset_in(level, before, mover) != offset_in(level, after, mover);
}

// All movers that may move in a tick.
std::vector<std::uint32_t> active_in_either(const GameState& before, const GameState& after) {
    std::vector<std::uint32_t> active;
    std::set_union(before.active_movers.begin(), before.active_movers.end(), after.active_movers.begin(),
                   after.active_movers.end(), std::back_inserter(active));
    return active;
}

struct NamePart {
    std::string_view part;
    Sound step;
};

// Words in names of this project's textures and of Quake's; the first that a name contains counts.
constexpr std::array kNameParts{
    NamePart{"carpet", Sound::StepCarpet}, NamePart{"rug", Sound::StepCarpet},   NamePart{"wood", Sound::StepWood},
    NamePart{"plank", Sound::StepWood},    NamePart{"crate", Sound::StepWood},   NamePart{"wizwood", Sound::StepWood},
    NamePart{"metal", Sound::StepMetal},   NamePart{"iron", Sound::StepMetal},   NamePart{"grate", Sound::StepMetal},
    NamePart{"brass", Sound::StepMetal},   NamePart{"copper", Sound::StepMetal}, NamePart{"bronze", Sound::StepMetal},
    NamePart{"steel", Sound::StepMetal},   NamePart{"cop1_", Sound::StepMetal},  NamePart{"plat_", Sound::StepMetal},
    NamePart{"tech", Sound::StepMetal},    NamePart{"slip", Sound::StepMetal},   NamePart{"sfloor", Sound::StepMetal},
    NamePart{"earth", Sound::StepEarth},   NamePart{"grass", Sound::StepEarth},  NamePart{"ground", Sound::StepEarth},
    NamePart{"dirt", Sound::StepEarth},    NamePart{"mud", Sound::StepEarth},    NamePart{"hedge", Sound::StepEarth},
};

constexpr Vec3<Unit> kDown{Unit{}, Unit{}, -Unit::from_int(1)};

std::string_view first_texture(const Level& bsp, ModelIndex model) {
    for (const FaceIndex face : bsp.models[model].faces) return bsp.texture_of(bsp.faces[face]).name;
    return {};
}

std::string_view texture_below(const GameLevel& level, const GameState& state) {
    if (state.player.ground > 0) return first_texture(*level.bsp, ModelIndex(state.player.ground));
    const auto face = pick_face(*level.bsp, {}, state.player.position, kDown);
    return face ? std::string_view(level.bsp->texture_of(level.bsp->faces[face->face]).name) : std::string_view();
}

// The sound of a step where the player stands: in water if the feet are in a liquid, else by the face below.
Sound step_sound(const GameLevel& level, const GameState& state) {
    if (state.player.depth != Depth::Dry) return Sound::StepWater;
    return step_sound_of_texture(texture_below(level, state));
}

}  // namespace

SoundStarts::SoundStarts(const GameLevel& level, const LevelSounds* own) : level_(level), own_(own) {
    mover_sounds_.reserve(level.movers.size());
    for (const Mover& mover : level.movers) mover_sounds_.push_back(mover_sounds(*level.bsp, mover.model));
}

void SoundStarts::note_tick(const GameState& before, const GameState& after, const TickReport& report,
                            std::vector<SoundSource>& sources) {
    note_player(before, after, report, sources);
    note_movers(before, after, sources);
    note_messages(before, after, report, sources);
}

std::int32_t SoundStarts::own_of_trigger(const Trigger& trigger, const GameState& state) const {
    if (trigger.found == 0) return own_of(trigger.entity);
    const std::vector<std::uint32_t>& taken = state.progress.taken;
    const std::size_t number = as_size(trigger.found) - 1;
    return number < taken.size() ? own_of(level_.items[taken[number]].entity) : LevelSounds::kNone;
}

bool SoundStarts::is_own_teleporter(std::uint32_t trigger) const {
    const Trigger& fired = level_.triggers[trigger];
    return fired.kind == TriggerKind::Teleport && own_of(fired.entity) != LevelSounds::kNone;
}

void SoundStarts::add(Sound sound, std::int32_t own, std::vector<SoundSource>& sources) {
    SoundSource source;
    source.sound = sound;
    source.own = own;
    source.serial = ++last_serial_;
    source.variant =
        static_cast<std::int32_t>(last_serial_ % static_cast<std::uint32_t>(std::max(row_of(sound).variants, 1)));
    sources.push_back(source);
}

// At the mover's box, or around all movers that touch each other and begin together, as the leaves of a door do. Loops
// have no serial.
void SoundStarts::add_at(Sound sound, std::uint32_t mover, const GameState& after, std::vector<SoundSource>& sources) {
    const ModelIndex model = level_.movers[mover].model;
    const Box box = box_of(level_.model(model).box).moved(offset_in(level_, after, mover));
    const std::int32_t own = own_of(level_.movers[mover].entity);
    if (sources.size() >= kMost) return;
    const auto same = std::find_if(sources.begin(), sources.end(), [&](const SoundSource& other) {
        return other.sound == sound && other.own == own && other.box.grown(kTouching).overlaps(box);
    });
    if (same != sources.end()) {
        same->box = same->box.united(box);
        return;
    }
    add(sound, own, sources);
    sources.back().model = model;
    sources.back().box = box;
    if (row_of(sound).is_loop()) sources.back().serial = 0;
}

void SoundStarts::note_player(const GameState& before, const GameState& after, const TickReport& report,
                              std::vector<SoundSource>& sources) {
    if (was_teleported(before.player, after.player)) {
        since_step_ = {};
        const std::vector<std::uint32_t>& fired = report.fired_triggers;
        if (std::none_of(fired.begin(), fired.end(), [this](std::uint32_t i) { return is_own_teleporter(i); }))
            add(Sound::Teleport, kStandard, sources);
        return;
    }
    if (!swims(before.player) && swims(after.player)) add(Sound::WaterIn, kStandard, sources);
    if (swims(before.player) && !swims(after.player)) add(Sound::WaterOut, kStandard, sources);
    const bool lands = !stands(before.player) && stands(after.player) && !swims(after.player);
    // The tick of the impact takes the speed away; the player stands in the next one.
    fall_speed_ = std::min(fall_speed_, before.player.velocity.z);
    if (lands && fall_speed_ < kHardLanding) add(Sound::Land, kStandard, sources);
    if (stands(after.player) || swims(after.player)) fall_speed_ = {};
    note_way(before, after, sources);
}

void SoundStarts::note_way(const GameState& before, const GameState& after, std::vector<SoundSource>& sources) {
    const Player &from = before.player, &to = after.player;
    Vec3<World> way = to.position - from.position;
    if (!swims(to)) {
        if (!stands(from) && stands(to)) since_step_ = kStride;  // a foot comes down
        if (!stands(to)) return;
        way.z = {};
    }
    // A player on a lift or a train moves without walking.
    if (to.velocity == Velocity{}) return;
    since_step_ += length_of(way);
    if (since_step_ < (swims(to) ? kStroke : kStride)) return;
    since_step_ = {};
    add(swims(to) ? Sound::Swim : step_sound(level_, after), kStandard, sources);
}

void SoundStarts::note_movers(const GameState& before, const GameState& after, std::vector<SoundSource>& sources) {
    if (before.active_movers.empty() && after.active_movers.empty() && were_moving_.empty()) return;
    const auto has_own = [this](std::uint32_t i) { return own_of(level_.movers[i].entity) != kStandard; };
    std::vector<std::uint32_t> moving;
    for (const std::uint32_t i : active_in_either(before, after))
        if (has_moved(level_, i, before, after)) moving.push_back(i);
    for (const std::uint32_t i : moving) {
        const bool starts = !std::binary_search(were_moving_.begin(), were_moving_.end(), i);
        const bool is_button = level_.movers[i].kind == MoverKind::Button;
        if (starts) add_at(is_button ? Sound::Button : mover_sounds_[i].start, i, after, sources);
        if (!is_button && !has_own(i)) add_at(mover_sounds_[i].move, i, after, sources);
    }
    for (const std::uint32_t i : were_moving_)
        if (!std::binary_search(moving.begin(), moving.end(), i) && level_.movers[i].kind != MoverKind::Button &&
            !has_own(i))
            add_at(mover_sounds_[i].stop, i, after, sources);
    were_moving_ = std::move(moving);
}

// A trigger's own sound replaces the game's; equal ones are played once.
void SoundStarts::note_messages(const GameState& before, const GameState& after, const TickReport& report,
                                std::vector<SoundSource>& sources) {
    bool is_told = false;
    const auto tell = [&](Sound sound, std::int32_t own) {
        add(sound, own, sources);
        is_told = true;
    };
    for (std::size_t i = 0; i < after.items.size(); ++i) {
        if (before.items[i] != ItemState::There || after.items[i] != ItemState::Taken) continue;
        const Item& taken = level_.items[i];
        tell(taken.item_class == ItemClass::Key ? Sound::Key : Sound::Lens, own_of(taken.entity));
    }
    std::set<std::int32_t> own_of_fired;
    for (const std::uint32_t i : report.fired_triggers) {
        const Trigger& trigger = level_.triggers[i];
        const std::int32_t own = own_of_trigger(trigger, after);
        if (!trigger.sounds_from)
            own_of_fired.insert(own);
        else if (own != kStandard) {
            add(Sound::Played, own, sources);
            sources.back().box = {*trigger.sounds_from, *trigger.sounds_from};
        }
    }
    own_of_fired.erase(kStandard);
    for (const std::int32_t own : own_of_fired) tell(Sound::Message, own);
    if (!own_of_fired.empty()) return;
    if (after.harm.damage > before.harm.damage) tell(Sound::Hurt, kStandard);
    if (before.exit < 0 && after.exit >= 0) tell(Sound::LevelEnd, kStandard);
    if (after.progress.found_secrets > before.progress.found_secrets) tell(Sound::Secret, kStandard);
    if (before.message.tick != after.message.tick && !is_told) add(Sound::Message, kStandard, sources);
}

Sound step_sound_of_texture(std::string_view name) {
    const std::string lower = lower_case(name);
    const auto found = std::find_if(kNameParts.begin(), kNameParts.end(),
                                    [&](const NamePart& part) { return lower.find(part.part) != lower.npos; });
    return found == kNameParts.end() ? Sound::StepStone : found->step;
}

MoverSounds mover_sounds(const Level& bsp, ModelIndex model) {
    const Entity* entity = entity_of(bsp, model);
    const ClassRole role = entity == nullptr ? ClassRole::None : role_of(*entity);
    if (role == ClassRole::Lift) return {Sound::LiftStart, Sound::LiftMove, Sound::LiftStop};
    if (role == ClassRole::Train) return {Sound::TrainStart, Sound::TrainMove, Sound::TrainStop};
    const Sound step = step_sound_of_texture(first_texture(bsp, model));
    if (step == Sound::StepWood) return {Sound::DoorStart, Sound::DoorMove, Sound::DoorStop};
    if (step == Sound::StepMetal) return {Sound::GateStart, Sound::GateMove, Sound::GateStop};
    return {Sound::SlabStart, Sound::SlabMove, Sound::SlabStop};
}

}  // namespace oblong

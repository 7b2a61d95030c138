#include <algorithm>

#include "engine/level/entities.h"
#include "engine/level/entity_classes.h"
#include "engine/scene/placed_models.h"
#include "game/simulation/entity_specs.h"

namespace oblong {
namespace {

const Vec3<World> kReach = world_vector(32, 32, 32);  // from a monster
constexpr std::size_t kElectrodes = 2;
constexpr World kLargestCell = World::from_int(256);  // of a teleporter that holds one monster

Box box_of_class(const ClassBox& box) {
    return {world_vector(box.mins[0], box.mins[1], box.mins[2]), world_vector(box.maxs[0], box.maxs[1], box.maxs[2])};
}

bool is_monster(ClassRole role) {
    return role == ClassRole::Monster || role == ClassRole::Boss || role == ClassRole::LastBoss;
}

bool is_cell(const Box& teleporter) {
    return teleporter.size().x <= kLargestCell && teleporter.size().y <= kLargestCell;
}

// Where the player meets a monster: at the exit of the teleporter that it waits in, if any.
Position meeting_place(const Position& origin, const std::vector<Trigger>& triggers) {
    for (const Trigger& trigger : triggers)
        if (trigger.kind == TriggerKind::Teleport && trigger.needs_activation && is_cell(*trigger.box) &&
            trigger.box->overlaps(player_box(origin)))
            return trigger.place.position;
    return origin;
}

constexpr int kNotTouched = 1, kCounterIsQuiet = 1, kPushesOnce = 1;  // spawnflags
constexpr std::int32_t kPushFactor = 10;
constexpr World kFastestPush = World::from_int(2000);     // Quake's largest speed, along each axis
constexpr std::int32_t kStrokes = 3;                      // of lightning; Chthon's health at normal skill
const Vec3<World> kShotReach = world_vector(32, 32, 64);  // from a trigger that Quake activates by a shot

std::optional<TriggerKind> trigger_kind(ClassRole role) {
    switch (role) {
        case ClassRole::TriggerOnce:
        case ClassRole::TriggerMultiple:
        case ClassRole::TriggerSecret:
        case ClassRole::TriggerOnlyRegistered:
            return TriggerKind::Multiple;
        case ClassRole::TriggerRelay:
            return TriggerKind::Relay;
        case ClassRole::TriggerCounter:
            return TriggerKind::Counter;
        case ClassRole::TriggerTeleport:
            return TriggerKind::Teleport;
        case ClassRole::TriggerPush:
            return TriggerKind::Push;
        case ClassRole::TriggerExit:
            return TriggerKind::Exit;
        case ClassRole::Checkpoint:
            return TriggerKind::Checkpoint;
        case ClassRole::Lightning:
            return TriggerKind::Lightning;
        default:
            return {};
    }
}

void read_multiple(const Entity& entity, ClassRole role, Trigger& trigger) {
    trigger.is_secret = role == ClassRole::TriggerSecret;
    trigger.wait_ticks = role == ClassRole::TriggerMultiple ? ticks_of(entity, "wait") : kForever;
    if (role == ClassRole::TriggerOnlyRegistered) return;
    if (has_flag(entity, kNotTouched))
        trigger.box.reset();
    else if (is_shot(entity))
        trigger.box = trigger.box->grown(kShotReach);
    if (has_direction(entity)) trigger.facing = direction_of(entity);
}

void read_counter(const Entity& entity, Trigger& trigger) {
    const World count = number_of(entity, "count");
    trigger.count = std::max(1, floor_of(count));
    trigger.wait_ticks = kForever;
    trigger.is_quiet = has_flag(entity, kCounterIsQuiet);
}

void read_push(const Entity& entity, Trigger& trigger) {
    const World speed = number_of(entity, "speed", 4000);
    const Velocity push = times(speed * kPushFactor, direction_of(entity));
    const auto bounded = [](World w) { return std::clamp(w, -kFastestPush, kFastestPush); };
    trigger.push = {bounded(push.x), bounded(push.y), bounded(push.z)};
    trigger.wait_ticks = has_flag(entity, kPushesOnce) ? kForever : 0;
}

bool read_checkpoint(const Entity& entity, Trigger& trigger) {
    const auto origin = origin_of(entity);
    if (!origin) return false;
    auto size = parse_world_vector(entity.value("size"));
    if (!size) size = parse_world_vector(usual_text(entity.value("classname"), "size"));
    const auto half = [](World w) { return scaled(std::clamp(w, World{}, World::from_int(kWorldEnd)), 1, 2); };
    trigger.box = Box{*origin, *origin}.grown({half(size->x), half(size->y), half(size->z)});
    trigger.place = {*origin, yaw_of(entity)};
    return true;
}

}  // namespace

std::optional<Trigger> trigger_left_of(const Entity& entity, const std::vector<Trigger>& triggers) {
    const EntityClass* const its_class = find_entity_class(entity.value("classname"));
    const auto origin = origin_of(entity);
    if (!its_class || !origin) return {};
    const bool is_met = is_monster(its_class->role);
    if (!is_met && its_class->role != ClassRole::Pickup) return {};
    Trigger trigger;
    if (its_class->role == ClassRole::LastBoss) trigger.kind = TriggerKind::Exit;
    trigger.wait_ticks = kForever;
    trigger.box = box_of_class(its_class->box).moved(is_met ? meeting_place(*origin, triggers) : *origin);
    if (is_met) trigger.box = trigger.box->grown(kReach);
    return trigger;
}

std::vector<std::uint32_t> find_electrodes(const std::vector<const Entity*>& entities) {
    std::vector<std::uint32_t> electrodes;
    for (std::size_t i = 0; i < entities.size() && electrodes.size() < kElectrodes; ++i)
        if (entities[i]->value("target") == "lightning") electrodes.push_back(static_cast<std::uint32_t>(i));
    return electrodes;
}

std::optional<Trigger> trigger_of(const Entity& entity, const Level& bsp) {
    const EntityClass* const its_class = find_entity_class(entity.value("classname"));
    const auto kind = its_class ? trigger_kind(its_class->role) : std::nullopt;
    if (!kind) return {};
    Trigger trigger;
    trigger.kind = *kind;
    if (its_class->shape == ClassShape::Brush) {
        const auto model = brush_model_of(entity, bsp);
        if (!model) return {};
        trigger.box = model_box(bsp, *model);
    }
    if (trigger.kind == TriggerKind::Multiple) read_multiple(entity, its_class->role, trigger);
    if (trigger.kind == TriggerKind::Counter) read_counter(entity, trigger);
    if (trigger.kind == TriggerKind::Push) read_push(entity, trigger);
    if (trigger.kind == TriggerKind::Checkpoint && !read_checkpoint(entity, trigger)) return {};
    if (trigger.kind == TriggerKind::Exit) trigger.next_map = entity.value("map");
    if (trigger.kind == TriggerKind::Lightning) trigger.count = kStrokes;
    if (trigger.kind == TriggerKind::Teleport) trigger.needs_activation = !entity.value("targetname").empty();
    return trigger;
}

}  // namespace oblong

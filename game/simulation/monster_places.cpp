#include "engine/level/entity_classes.h"
#include "game/simulation/entity_keys.h"
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

}  // namespace oblong

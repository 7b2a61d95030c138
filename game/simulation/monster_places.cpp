#include "game/simulation/monster_places.h"

#include <string>
#include <string_view>

#include "game/simulation/entity_keys.h"

namespace oblong {
namespace {

const Vec3<World> kReach = world_vector(32, 32, 32);  // from a monster
constexpr std::size_t kElectrodes = 2;
constexpr World kLargestCell = World::from_int(256);  // of a teleporter that holds one monster

// Around the origin, as large as Quake's.
Box size_of(std::string_view name) {
    if (name == "monster_boss") return {world_vector(-128, -128, -24), world_vector(128, 128, 256)};
    if (name == "monster_oldone") return {world_vector(-160, -128, -24), world_vector(160, 128, 256)};
    if (!name.starts_with("monster_")) return {world_vector(-16, -16, -24), world_vector(32, 32, 56)};
    return {world_vector(-32, -32, -24), world_vector(32, 32, 64)};
}

bool is_cell(const Box& teleporter) {
    return teleporter.size().x <= kLargestCell && teleporter.size().y <= kLargestCell;
}

// Where a monster is met: at the exit of the teleporter that it waits in, if it does.
Position meeting_place(const Position& origin, const std::vector<Trigger>& triggers) {
    for (const Trigger& trigger : triggers)
        if (trigger.kind == TriggerKind::Teleport && trigger.needs_activation && is_cell(*trigger.box) &&
            trigger.box->overlaps(player_box(origin)))
            return trigger.place.position;
    return origin;
}

}  // namespace

bool is_left_as_trigger(const Entity& entity) {
    const std::string name = entity.value("classname");
    return name.starts_with("monster_") || name.starts_with("item_") || name.starts_with("weapon_") ||
           name.starts_with("misc_explobox");
}

std::optional<Trigger> trigger_left_of(const Entity& entity, const std::vector<Trigger>& triggers) {
    const std::string name = entity.value("classname");
    const auto origin = origin_of(entity);
    if (!origin) return {};
    const bool is_monster = name.starts_with("monster_");
    Trigger trigger;
    if (name == "monster_oldone") trigger.kind = TriggerKind::Exit;
    trigger.wait_ticks = kForever;
    trigger.box = size_of(name).moved(is_monster ? meeting_place(*origin, triggers) : *origin);
    if (is_monster) trigger.box = trigger.box->grown(kReach);
    return trigger;
}

std::vector<std::uint32_t> find_electrodes(const std::vector<const Entity*>& entities) {
    std::vector<std::uint32_t> electrodes;
    for (std::size_t i = 0; i < entities.size() && electrodes.size() < kElectrodes; ++i)
        if (entities[i]->value("target") == "lightning") electrodes.push_back(static_cast<std::uint32_t>(i));
    return electrodes;
}

}  // namespace oblong

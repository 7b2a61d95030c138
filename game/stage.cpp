#include "game/stage.h"

#include <string>

#include "game/entity_keys.h"
#include "game/mover_specs.h"

namespace oblong {
namespace {

using Indices = std::vector<std::int32_t>;

const Entity* find_entity(const Level& level, const std::string& key, const std::string& value) {
    for (const Entity& entity : level.entities)
        if (entity.value(key) == value) return &entity;
    return nullptr;
}

// The movers that answer to the entity's target.
Indices targets_of(const Entity& entity, const std::vector<const Entity*>& movers) {
    const std::string target = entity.value("target");
    Indices found;
    for (std::size_t i = 0; i < movers.size() && !target.empty(); ++i)
        if (movers[i]->value("targetname") == target) found.push_back(static_cast<std::int32_t>(i));
    return found;
}

std::optional<Trigger::Exit> exit_of(const Entity& entity, const Level& level) {
    const std::string target = entity.value("target");
    const Entity* exit = target.empty() ? nullptr : find_entity(level, "targetname", target);
    const auto origin = exit == nullptr ? std::nullopt : origin_of(*exit);
    if (!origin) return {};
    return Trigger::Exit{*origin + place_of(0, 0, 27), yaw_of(*exit)};  // Quake's: clear of the ground below
}

std::optional<Trigger> trigger_of(const Entity& entity, const Level& level, const std::vector<const Entity*>& movers) {
    const auto model = model_of(entity, level);
    if (!model) return {};
    Trigger trigger;
    trigger.box = box_of(level.models[*model].box);
    const std::string name = entity.value("classname");
    if (name == "trigger_changelevel")
        trigger.ends_level = true;
    else if (name == "trigger_teleport")
        trigger.teleports_to = exit_of(entity, level);
    else if (name == "trigger_once" || name == "trigger_multiple")
        trigger.starts = targets_of(entity, movers);
    else
        return {};
    return trigger;
}

void add_still_model(Stage& stage, const Entity& entity) {
    const auto model = model_of(entity, *stage.level);
    const std::string name = entity.value("classname");
    if (!model || name.rfind("func_", 0) != 0) return;
    stage.still_models.push_back(*model);
    if (name != "func_illusionary") stage.solid_still_models.push_back(*model);
}

void add_models(Stage& stage, std::vector<const Entity*>& entities) {
    for (const Entity& entity : stage.level->entities) {
        const auto mover = mover_of(entity, *stage.level);
        if (!mover) {
            add_still_model(stage, entity);
            continue;
        }
        stage.movers.push_back(*mover);
        entities.push_back(&entity);
    }
    link_doors(stage.movers, entities, *stage.level);
    for (std::size_t i = 0; i < stage.movers.size(); ++i) stage.movers[i].starts = targets_of(*entities[i], entities);
}

// What something else sets off doesn't answer to the player's touch; what nothing can set off does.
void leave_touch_to_callers(Stage& stage, const std::vector<const Entity*>& entities) {
    std::vector<bool> is_called(stage.movers.size());
    const auto note = [&](const Indices& starts) {
        for (const std::int32_t i : starts) is_called[static_cast<std::size_t>(i)] = true;
    };
    for (const Mover& mover : stage.movers) note(mover.starts);
    for (const Trigger& trigger : stage.triggers) note(trigger.starts);
    for (std::size_t i = 0; i < stage.movers.size(); ++i)
        if (is_called[i] && entities[i]->value("classname") == "func_door") stage.movers[i].touch.reset();
}

void add_start(Stage& stage) {
    const Entity* start = find_entity(*stage.level, "classname", "info_player_start");
    if (start == nullptr) start = find_entity(*stage.level, "classname", "info_player_deathmatch");
    if (start == nullptr) return;
    stage.player_start = origin_of(*start).value_or(Place{}) + place_of(0, 0, 1);
    stage.player_yaw = yaw_of(*start);
}

}  // namespace

Stage make_stage(const Level& level) {
    Stage stage;
    stage.level = &level;
    std::vector<const Entity*> mover_entities;
    add_models(stage, mover_entities);
    for (const Entity& entity : level.entities)
        if (const auto trigger = trigger_of(entity, level, mover_entities)) stage.triggers.push_back(*trigger);
    leave_touch_to_callers(stage, mover_entities);
    add_start(stage);
    if (const Entity* end = find_entity(level, "classname", "trigger_changelevel"))
        stage.end_message = end->value("message");
    return stage;
}

GameState start_of(const Stage& stage) {
    GameState state;
    state.player.place = stage.player_start;
    state.player.yaw = stage.player_yaw;
    state.movers.resize(stage.movers.size());
    return state;
}

Place offset_of(const Mover& mover, const MoverState& state) {
    const auto part = [&](World way) {
        return World::from_raw(
            static_cast<std::int32_t>(std::int64_t{way.raw} * state.travelled.raw / mover.length.raw));
    };
    return mover.start + Place{part(mover.way.x), part(mover.way.y), part(mover.way.z)};
}

}  // namespace oblong

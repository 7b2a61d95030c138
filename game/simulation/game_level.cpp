#include "game/simulation/game_level.h"

#include <unordered_map>

#include "engine/base/input_error.h"
#include "engine/base/table.h"
#include "game/simulation/entity_specs.h"
#include "game/simulation/items.h"

namespace oblong {
namespace {

const Entity* find_class(const Level& bsp, const std::string& classname) {
    for (const Entity& entity : bsp.entities)
        if (entity.value("classname") == classname) return &entity;
    return nullptr;
}

// Makes a game level step by step; what it keeps meanwhile are the entities by name and those of the movers.
class LevelBuilder {
  public:
    explicit LevelBuilder(const Level& bsp) {
        level_.bsp = &bsp;
        for (const Entity& entity : bsp.entities)
            if (const std::string name = entity.value("targetname"); !name.empty()) by_name_.emplace(name, &entity);
    }

    GameLevel build() {
        add_models();
        add_triggers();
        add_lights();
        add_items();
        resolve_targets();
        make_trees();
        add_start();
        if (const Entity* end = find_class(*level_.bsp, "trigger_changelevel"))
            level_.end_message = end->value("message");
        return std::move(level_);
    }

  private:
    // The target of a name that some mover or teleporter has; a new one where there is none yet.
    Target& target_named(const std::string& name) {
        const auto [found, is_new] = target_of_.emplace(name, static_cast<TargetIndex>(level_.targets.size()));
        if (is_new) level_.targets.emplace_back();
        return at(level_.targets, found->second);
    }

    TargetIndex target_of(const Entity& entity) const {
        const auto found = target_of_.find(entity.value("target"));
        return found == target_of_.end() ? kNoTarget : found->second;
    }

    void add_models() {
        const World longest = longest_travel(*level_.bsp);
        for (const Entity& entity : level_.bsp->entities) {
            if (const auto mover = mover_of(entity, *level_.bsp, longest))
                add_mover(entity, *mover);
            else
                add_static_model(entity);
        }
        link_doors(level_.movers, mover_entities_, *level_.bsp);
    }

    void add_mover(const Entity& entity, const Mover& mover) {
        if (level_.movers.size() == kMostMovers)
            throw InputError("entities", "more than 16,384 doors, lifts and buttons, expected no more");
        const std::string name = entity.value("targetname");
        if (!name.empty()) target_named(name).movers.push_back(static_cast<std::uint32_t>(level_.movers.size()));
        level_.movers.push_back(mover);
        mover_entities_.push_back(&entity);
    }

    void add_static_model(const Entity& entity) {
        const auto model = model_of(entity, *level_.bsp);
        const std::string name = entity.value("classname");
        if (!model || name.rfind("func_", 0) != 0) return;
        level_.static_models.push_back(*model);
        if (name != "func_illusionary") level_.solid_static_models.push_back(*model);
    }

    void add_triggers() {
        for (const Entity& entity : level_.bsp->entities) {
            const std::string name = entity.value("classname");
            const auto model = model_of(entity, *level_.bsp);
            if (!model) continue;
            Trigger trigger;
            trigger.box = box_of(level_.model(*model).box);
            trigger.switches_once = name == "trigger_once";
            if (name == "trigger_changelevel")
                end_level(entity, trigger);
            else if (name == "trigger_teleport" ? !make_teleporter(entity, trigger)
                                                : name != "trigger_once" && name != "trigger_multiple")
                continue;
            level_.triggers.push_back(trigger);
            trigger_entities_.push_back(&entity);
        }
    }

    static void end_level(const Entity& entity, Trigger& trigger) {
        trigger.ends_level = true;
        trigger.next_map = entity.value("map");
    }

    // As in Quake, one with a name works only for a moment after it was activated. False for one without an exit.
    bool make_teleporter(const Entity& entity, Trigger& trigger) {
        const auto exit = by_name_.find(entity.value("target"));
        const auto origin = exit == by_name_.end() ? std::nullopt : origin_of(*exit->second);
        if (!origin) return false;
        trigger.teleports_to = {*origin + world_vector(0, 0, 27), yaw_of(*exit->second)};  // Quake's height of exits
        const std::string name = entity.value("targetname");
        if (name.empty()) return true;
        trigger.activation = level_.targeted_teleporters++;
        target_named(name).teleporters.push_back(*trigger.activation);
        return true;
    }

    void add_lights() {
        for (const Entity& entity : level_.bsp->entities) {
            const std::optional<SwitchableLight> light = switchable_light_of(entity);
            if (!light) continue;
            target_named(entity.value("targetname")).light_styles |= light->style;
            if (light->starts_dark) level_.dark_styles |= light->style;
        }
    }

    void add_items() {
        for (std::size_t i = 0; i < level_.bsp->entities.size(); ++i) {
            const Entity& entity = level_.bsp->entities[i];
            std::optional<Item> item = item_of(entity);
            if (!item) continue;
            item->entity = i;
            item->fires.message = message_of(entity, default_message(item->item_class));
            level_.items.push_back(*item);
        }
    }

    // An entity's "message", or another where it has none; equal ones are kept once.
    MessageIndex message_of(const Entity& entity, std::string_view otherwise = {}) {
        std::string text = entity.value("message");
        if (text.empty()) text = otherwise;
        if (text.empty()) return kNoMessage;
        const auto [found, is_new] = message_numbers_.emplace(text, static_cast<MessageIndex>(level_.messages.size()));
        if (is_new) level_.messages.push_back(std::move(text));
        return found->second;
    }

    void resolve_targets() {
        std::vector<bool> is_activated(level_.targets.size());
        const auto resolve = [&](const Entity& entity) {
            const TargetIndex target = target_of(entity);
            if (target != kNoTarget) at(is_activated, target) = true;
            return target;
        };
        for (std::size_t i = 0; i < level_.movers.size(); ++i) level_.movers[i].target = resolve(*mover_entities_[i]);
        for (std::size_t i = 0; i < level_.triggers.size(); ++i)
            if (!level_.triggers[i].ends_level && !level_.triggers[i].teleports_to)
                level_.triggers[i].target = resolve(*trigger_entities_[i]);
        for (Item& item : level_.items) item.fires.target = resolve(level_.bsp->entities[item.entity]);
        for (std::size_t i = 0; i < is_activated.size(); ++i)
            if (is_activated[i]) leave_to_activators(level_.targets[i]);
    }

    // A door that something activates doesn't answer to the player's touch; one that nothing can activate does.
    void leave_to_activators(const Target& target) {
        for (const std::uint32_t i : target.movers)
            if (mover_entities_[i]->value("classname") == "func_door") level_.movers[i].touch_box.reset();
    }

    void make_trees() {
        std::vector<BoxTree::Entry> touch_boxes, trigger_boxes, item_boxes, obstacles;
        const auto add = [](const Box& box, std::vector<BoxTree::Entry>& entries, std::size_t number) {
            entries.push_back({box, static_cast<std::uint32_t>(number)});
        };
        for (const ModelIndex model : level_.solid_static_models)
            add(obstacle_box(level_, model, {}), obstacles, obstacles.size());
        for (std::size_t i = 0; i < level_.movers.size(); ++i) {
            const Mover& mover = level_.movers[i];
            if (mover.touch_box) add(*mover.touch_box, touch_boxes, i);
            const Box at_start = obstacle_box(level_, mover.model, mover.start);
            add(at_start.united(at_start.moved(mover.travel)), obstacles, obstacles.size());
        }
        for (std::size_t i = 0; i < level_.triggers.size(); ++i) add(level_.triggers[i].box, trigger_boxes, i);
        for (std::size_t i = 0; i < level_.items.size(); ++i) add(level_.items[i].box, item_boxes, i);
        level_.item_boxes = BoxTree(std::move(item_boxes));
        level_.touch_boxes = BoxTree(std::move(touch_boxes));
        level_.trigger_boxes = BoxTree(std::move(trigger_boxes));
        level_.obstacles = BoxTree(std::move(obstacles));
    }

    void add_start() {
        const Entity* start = find_class(*level_.bsp, "info_player_start");
        if (start == nullptr) start = find_class(*level_.bsp, "info_player_deathmatch");
        if (start == nullptr) return;
        level_.player_start = origin_of(*start).value_or(Position{}) + world_vector(0, 0, 1);
        level_.player_yaw = yaw_of(*start);
    }

    GameLevel level_;
    std::vector<const Entity*> mover_entities_, trigger_entities_;  // in the order of the movers and the triggers
    std::unordered_map<std::string, const Entity*> by_name_;        // the first of each targetname
    std::unordered_map<std::string, TargetIndex> target_of_;        // by targetname
    std::unordered_map<std::string, MessageIndex> message_numbers_;
};

}  // namespace

GameLevel make_game_level(const Level& bsp) {
    return LevelBuilder(bsp).build();
}

GameState start_of(const GameLevel& level) {
    GameState state;
    state.player.position = level.player_start;
    state.player.yaw = level.player_yaw;
    state.movers.resize(level.movers.size());
    state.teleporter_ends.resize(level.targeted_teleporters);
    state.dark_styles = level.dark_styles;
    state.items.resize(level.items.size());
    state.respawn = {level.player_start, level.player_yaw};
    return state;
}

std::string_view next_map(const GameLevel& level, const GameState& state) {
    if (state.exit < 0) return {};
    return at(level.triggers, state.exit).next_map;
}

Box obstacle_box(const GameLevel& level, ModelIndex model, const Vec3<World>& offset) {
    return box_of(level.model(model).box).grown(world_vector(2, 2, 2)).moved(offset);
}

Vec3<World> offset_of(const Mover& mover, const MoverState& state) {
    return mover.start + scaled(mover.travel, state.travelled, mover.length);
}

}  // namespace oblong

#pragma once

#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/level/entity_classes.h"
#include "game/simulation/entity_specs.h"
#include "game/simulation/game_level.h"

namespace oblong {

/// Makes a game level from a level's entities, in two steps: first it adds all entities under their names, then it
/// connects them.
class LevelBuilder {
  public:
    explicit LevelBuilder(const Level& bsp);

    /// Throws InputError for more than kMostMovers movers.
    GameLevel build();

  private:
    // In the level's list.
    std::size_t index_of(const Entity& entity) const { return as_size(&entity - level_.bsp->entities.data()); }
    void add_entity(const Entity& entity);
    bool add_mover(const Entity& entity);
    void add_wall(const Entity& entity, ClassRole role);
    void add_trigger(const Entity& entity);
    bool find_exit(const Entity& entity, Trigger& trigger) const;
    void add_item(const Entity& entity);
    void add_intermission(const Entity& entity);
    void add_light(const Entity& entity);
    void add_what_monsters_leave();
    void add_start();

    void connect_movers();
    void connect_doors();
    void connect_triggers();
    void connect_lightning();
    void add_counter_messages();
    void make_trees();

    Target& target_named(const std::string& name);
    void name(const Entity& entity, EntityRef::Kind kind, std::size_t count);
    TargetIndex target_of(const Entity& entity, const char* key) const;
    TargetIndex both_targets_of(const Entity& entity);
    Firing firing_of(const Entity& entity, std::string_view usual_message = {});
    MessageIndex message(std::string text);
    std::uint32_t key_named(const std::string& its_name);
    std::vector<bool> activated_movers() const;

    GameLevel level_;
    World longest_travel_;
    std::vector<const Entity*> present_;                            // entities that are in the level
    std::vector<const Entity*> mover_entities_, trigger_entities_;  // in the order of the movers and the triggers
    EntitiesByName by_name_;
    std::unordered_map<std::string, TargetIndex> target_of_;  // by targetname
    std::map<std::pair<TargetIndex, TargetIndex>, TargetIndex> both_of_;
    std::size_t targets_of_both_ = 0;
    std::unordered_map<std::string, MessageIndex> message_of_;
};

}  // namespace oblong

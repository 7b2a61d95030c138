#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "game/simulation/game_level.h"

namespace oblong {

// Makes movers, trains, groups of doors and triggers from a level's entities.

/// How far a mover may travel without moving a vertex of the level out of the range of world coordinates.
World longest_travel(const Level& bsp);

/// The mover that an entity describes (func_door, func_door_secret, func_button, func_plat), as in Quake's game;
/// nothing for any other entity, for one without a model, and if it would travel further than `longest`. Links to other
/// entities (linked doors, targets, messages) are left out.
std::optional<Mover> mover_of(const Entity& entity, const Level& bsp, World longest);

/// True for an entity that Quake activates by a shot: here by touch.
bool is_shot(const Entity& entity);

/// Where the player touches a mover's model at its place in the file: 2 units around it.
Box contact_box(const Box& model);

/// The first entity of each targetname.
using EntitiesByName = std::unordered_map<std::string, const Entity*>;

/// The train that a func_train describes: the lowest corner of its model goes from one path_corner to the next. It
/// waits for their "wait", for ever if that is negative or no corner follows. Nothing for any other entity, for one
/// without a model or a first corner, and if it would travel further than `longest`.
std::optional<Mover> train_of(const Entity& entity, const EntitiesByName& by_name, const Level& bsp, World longest);

/// Doors that touch each other open together (except those with spawnflag 4): sets Mover::group and
/// Mover::group_members. `entities[i]` is that of `movers[i]`.
void link_doors(std::vector<Mover>& movers, const std::vector<const Entity*>& entities, const Level& bsp);

/// Sets the touch boxes of linked doors. `is_activated[i]`: something activates mover i. As in Quake's game, a door
/// opens when the player comes near, with its whole group, unless it needs a key or something activates it. A door that
/// Quake opens by a shot opens by contact; one that only has a message shows it on contact.
void make_doors_touchable(std::vector<Mover>& movers, const std::vector<const Entity*>& entities,
                          const std::vector<bool>& is_activated, const Level& bsp);

/// The trigger that an entity describes, as in Quake's game: trigger_ once, multiple, secret, onlyregistered, counter,
/// relay, teleport, push, changelevel, and info_checkpoint, event_lightning; nothing for any other entity. Links to
/// other entities (targets, messages, a teleporter's exit) are left out.
std::optional<Trigger> trigger_of(const Entity& entity, const Level& bsp);

/// The message of a secret that has none.
inline constexpr std::string_view kSecretMessage = "You found a secret place";

}  // namespace oblong

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "game/simulation/game_level.h"

namespace oblong {

// What the entities of a level become: movers, trains, doors that open together, triggers.

/// How far a mover may be from its place so that no vertex of the level, moved along, leaves the format of world
/// coordinates.
World longest_travel(const Level& bsp);

/// The mover that an entity describes (func_door, func_door_secret, func_button, func_plat), as Quake's game does;
/// nothing for any other entity, for one without a model, and where it would travel further than `longest`. Without
/// what concerns other entities: linked doors, targets, messages.
std::optional<Mover> mover_of(const Entity& entity, const Level& bsp, World longest);

/// True for an entity that has to be shot to activate it: here it answers to touch.
bool is_shot(const Entity& entity);

/// Where the player touches a mover's model that is where the file has it: from nearby.
Box contact_box(const Box& model);

/// The first entity of each targetname.
using EntitiesByName = std::unordered_map<std::string, const Entity*>;

/// The train that a func_train describes: it goes from one path_corner to the next, the least corner of its model at
/// theirs. It waits for their "wait", for ever where that is negative or no corner follows. Nothing for any other
/// entity, one without a model or a first corner, and where it would travel further than `longest`.
std::optional<Mover> train_of(const Entity& entity, const EntitiesByName& by_name, const Level& bsp, World longest);

/// Doors that touch each other open together (but for those with spawnflag 4): sets Mover::group and
/// Mover::group_members. `entities[i]` is that of `movers[i]`.
void link_doors(std::vector<Mover>& movers, const std::vector<const Entity*>& entities, const Level& bsp);

/// Gives doors that have been linked what the player touches them by. `is_activated[i]`: something activates mover i.
/// As in Quake's game, a door opens for the player who is near, the whole group as one, unless it wants a key or has a
/// name that something activates. One that would have to be shot wants contact, and so does one that only says
/// something.
void make_doors_touchable(std::vector<Mover>& movers, const std::vector<const Entity*>& entities,
                          const std::vector<bool>& is_activated, const Level& bsp);

/// The trigger that an entity describes, as Quake's game does: trigger_ once, multiple, secret, onlyregistered,
/// counter, relay, teleport, push, changelevel, and info_checkpoint, event_lightning; nothing for any other entity.
/// Without what concerns other entities: targets, messages, a teleporter's exit.
std::optional<Trigger> trigger_of(const Entity& entity, const Level& bsp);

/// What a secret says that has no message of its own.
inline constexpr std::string_view kSecretMessage = "You found a secret place";

}  // namespace oblong

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/level/entity_classes.h"
#include "game/simulation/game_level.h"

namespace oblong {

// The values of entities' keys. A key counts as absent if its value is not a number, or too large: then the default of
// its class holds (usual_text).

/// "origin"; nothing where it is absent, not three numbers, or outside +-kWorldEnd.
std::optional<Position> origin_of(const Entity& entity);

/// The first entity of each targetname.
using EntitiesByName = std::unordered_map<std::string, const Entity*>;

/// The entity of a name that has an origin; null: none.
const Entity* find_placed(const std::string& name, const EntitiesByName& by_name);

/// "angle" (degrees), or the second number of "angles", as a turn from +x to +y.
Angle yaw_of(const Entity& entity);

/// True if "angle" or "angles" name a direction: 0 names none, 360 is +x.
bool has_direction(const Entity& entity);

/// The direction of "angles" (pitch, yaw, roll) or "angle" (yaw), of length 1. A yaw of -1 is up, -2 is down.
Vec3<Unit> direction_of(const Entity& entity);

/// The number of a key in world units. If it is absent, 0, or beyond +-`largest`, the default of its class, or 0. As in
/// Quake's game code, 0 counts as absent.
World number_of(const Entity& entity, const char* key, std::int32_t largest = kWorldEnd);

/// The same rounded down, 0 for what is negative.
std::int32_t whole_number_of(const Entity& entity, const char* key);

/// The key "speed" in world units a second, 1 to 4000, as units in a tick.
World speed_per_tick_of(const Entity& entity);

/// The number of ticks, rounded up, that a key gives in seconds; kForever for less than 0.
std::int32_t ticks_of(const Entity& entity, const char* key);

/// True where one of the bits of "spawnflags" is set.
bool has_flag(const Entity& entity, int flags);

/// The box of a class around its origin.
Box box_of_class(const ClassBox& box);

/// True for an entity that is absent in single-player games at Quake's normal skill (spawnflag 512).
inline bool is_left_out(const Entity& entity) {
    return has_flag(entity, 512);
}

/// The box of a brush model at its place in the file.
inline Box model_box(const Level& bsp, ModelIndex model) {
    return box_of(bsp.models[model].box);
}

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
/// relay, teleport, push, changelevel, hurt, ladder, and func_timer, func_breakable, play_sound, info_checkpoint,
/// event_lightning; nothing for any other entity. Links to other entities (targets, messages, a teleporter's exit) are
/// left out.
std::optional<Trigger> trigger_of(const Entity& entity, const Level& bsp);

/// The message of a secret that has none.
inline constexpr std::string_view kSecretMessage = "You found a secret place";

// Monsters, weapons and Quake's other items are not in the game, but their effects on the level are: a monster's
// targets are activated at its death, an item's when it is taken. Here that happens once, when the player comes within
// 32 units of the monster's place, or touches the item's box. The place of a monster that waits in a teleporter is the
// teleporter's exit. Where a level has lightning (event_lightning), Chthon (monster_boss) dies of the third stroke
// instead; each stroke needs both electrodes at the same end of their way.

/// The trigger in place of a monster or a pickup (ClassRole); nothing for others, or without an origin. `fires` is left
/// empty. `triggers` are those of the level: only its teleporters are used.
std::optional<Trigger> trigger_left_of(const Entity& entity, const std::vector<Trigger>& triggers);

/// The movers that "target" the name "lightning": Chthon's electrodes. `entities[i]` is that of mover i.
std::vector<std::uint32_t> find_electrodes(const std::vector<const Entity*>& entities);

}  // namespace oblong

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/table.h"
#include "engine/level/level.h"
#include "game/simulation/box_tree.h"
#include "game/simulation/geometry.h"
#include "game/simulation/state.h"

namespace oblong {

/// An index into GameLevel::targets, or kNoTarget.
using TargetIndex = std::int32_t;
inline constexpr TargetIndex kNoTarget = -1;

/// An index into GameLevel::messages, or kNoMessage.
using MessageIndex = std::int32_t;
inline constexpr MessageIndex kNoMessage = -1;

/// What an entity does to others when it is activated.
struct Firing {
    TargetIndex target = kNoTarget;     ///< what it activates
    MessageIndex message = kNoMessage;  ///< what it shows the player
};

enum class ItemClass : std::uint8_t { Lens, SilverKey, GoldKey };

/// Bits of GameState::keys.
inline constexpr std::uint8_t kSilverKey = 1, kGoldKey = 2;

/// A thing that the player takes by touching it.
struct Item {
    ItemClass item_class = ItemClass::Lens;
    Position position;
    Box box;                 ///< that the player touches
    std::size_t entity = 0;  ///< into Level::entities
    Firing fires;            ///< when it is taken
};

/// A brush model that travels between two ends: a door, a lift or a button.
struct Mover {
    ModelIndex model;
    Vec3<World> start;   ///< offset of the model where it rests
    Vec3<World> travel;  ///< from there to its other end
    World length;        ///< of `travel`, above 0
    World speed_per_tick;
    std::int32_t wait_ticks = 0;     ///< at the other end; kForever: it stays there
    std::optional<Box> touch_box;    ///< the player in here activates it
    TargetIndex target = kNoTarget;  ///< what it activates in turn (a button)
    bool is_button = false;          ///< shows the other frames of its textures unless it is at its start

    static constexpr std::int32_t kForever = -1;
};

/// A volume that does something to the player who enters it.
struct Trigger {
    Box box;
    bool ends_level = false;
    std::string next_map;            ///< where a trigger_changelevel leads, as "e1m2"; may be empty
    bool switches_once = false;      ///< lights of its target: once, not each time that the player enters
    TargetIndex target = kNoTarget;  ///< what it activates
    std::optional<Place> teleports_to;
    std::optional<std::uint32_t> activation;  ///< into GameState::teleporter_ends: works only after it was activated
};

/// The most doors, lifts and buttons of a level; Quake allows 255 brush models, its successors some thousands.
inline constexpr std::size_t kMostMovers = 16'384;

/// Everything that is activated by one name.
struct Target {
    std::vector<std::uint32_t> movers;       ///< indices into GameLevel::movers
    std::vector<std::uint32_t> teleporters;  ///< indices into GameState::teleporter_ends
    std::uint64_t light_styles = 0;          ///< a bit for each style of its lights, switched off and on by turns
};

/// The part of a game that never changes: what it needs of a level.
struct GameLevel {
    const Level* bsp = nullptr;  ///< outlives the game level
    std::vector<Mover> movers;
    std::vector<Trigger> triggers;
    std::vector<Target> targets;
    std::vector<Item> items;
    std::vector<std::string> messages;
    std::uint32_t targeted_teleporters = 0;       ///< how many GameState::teleporter_ends has
    std::uint64_t dark_styles = 0;                ///< GameState::dark_styles at the start
    std::vector<ModelIndex> static_models;        ///< brush models that are drawn and never move
    std::vector<ModelIndex> solid_static_models;  ///< those of them that stop the player
    BoxTree touch_boxes;                          ///< of movers, by their indices
    BoxTree trigger_boxes;                        ///< by the indices of triggers
    BoxTree item_boxes;                           ///< by the indices of items
    BoxTree obstacles;  ///< all places that solid static models, then movers, may take; numbered in this order
    Position player_start;
    Angle player_yaw;
    std::string end_message;  ///< what the level says at its end; may be empty

    const Target& target(TargetIndex index) const { return at(targets, index); }
    const SubModel& model(ModelIndex index) const { return bsp->models[index]; }
};

/// Reads entities: info_player_start, func_door, func_plat, func_button, trigger_once, trigger_multiple,
/// trigger_teleport, trigger_changelevel, item_lens, item_key1, item_key2, and lights with a targetname and a style
/// from 32 on; any other func_ stands still. Keys that are no numbers count as absent. Throws InputError for more than
/// kMostMovers movers: doors that overlap are compared in pairs.
GameLevel make_game_level(const Level& bsp);

/// The state in which a level begins.
GameState start_of(const GameLevel& level);

/// The map that follows the level as it was left, as "e1m2"; empty where its end names none or it has not ended.
std::string_view next_map(const GameLevel& level, const GameState& state);

/// The box of a model at an offset, grown by some room for the rounding of files: compilers write boxes up to a unit
/// too small.
Box obstacle_box(const GameLevel& level, ModelIndex model, const Vec3<World>& offset);

/// Where a mover's model is, as an offset.
Vec3<World> offset_of(const Mover& mover, const MoverState& state);

}  // namespace oblong

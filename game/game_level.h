#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/table.h"
#include "engine/level/level.h"
#include "game/geometry.h"
#include "game/state.h"

namespace oblong {

/// An index into GameLevel::targets, or kNoTarget.
using TargetIndex = std::int32_t;
inline constexpr TargetIndex kNoTarget = -1;

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

    static constexpr std::int32_t kForever = -1;
};

/// A volume that does something to the player who enters it.
struct Trigger {
    Box box;
    bool ends_level = false;
    TargetIndex target = kNoTarget;  ///< what it activates
    struct Exit {
        Position position;
        Angle yaw;
    };
    std::optional<Exit> teleports_to;
    std::optional<std::uint32_t> activation;  ///< into GameState::teleporter_ticks: works only after it was activated
};

/// The most doors, lifts and buttons of a level; Quake allows 255 brush models, its successors some thousands.
inline constexpr std::size_t kMostMovers = 16'384;

/// Everything that is activated by one name.
struct Target {
    std::vector<std::uint32_t> movers;       ///< indices into GameLevel::movers
    std::vector<std::uint32_t> teleporters;  ///< indices into GameState::teleporter_ticks
};

/// The part of a game that never changes: what it needs of a level.
struct GameLevel {
    const Level* bsp = nullptr;  ///< outlives the game level
    std::vector<Mover> movers;
    std::vector<Trigger> triggers;
    std::vector<Target> targets;
    std::uint32_t targeted_teleporters = 0;       ///< how many GameState::teleporter_ticks has
    std::vector<ModelIndex> static_models;        ///< brush models that are drawn and never move
    std::vector<ModelIndex> solid_static_models;  ///< those of them that stop the player
    Position player_start;
    Angle player_yaw;
    std::string end_message;  ///< what the level says at its end; may be empty

    const Target& target(TargetIndex index) const { return at(targets, index); }
    const SubModel& model(ModelIndex index) const { return bsp->models[index]; }
};

/// Reads entities: info_player_start, func_door, func_plat, func_button, trigger_once, trigger_multiple,
/// trigger_teleport, trigger_changelevel; any other func_ stands still. Keys that are no numbers count as absent.
/// Throws InputError for more than kMostMovers movers: doors that overlap are compared in pairs.
GameLevel make_game_level(const Level& bsp);

/// The state in which a level begins.
GameState start_of(const GameLevel& level);

/// Where a mover's model is, as an offset.
Vec3<World> offset_of(const Mover& mover, const MoverState& state);

}  // namespace oblong

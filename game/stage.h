#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/level/level.h"
#include "game/box.h"
#include "game/state.h"

namespace oblong {

/// A brush model that travels between two ends: a door, a lift or a button.
struct Mover {
    ModelIndex model;
    Place start;   ///< offset of the model where it rests
    Place way;     ///< from there to its other end
    World length;  ///< of the way, above 0
    World speed_per_tick;
    std::int32_t wait_ticks = 0;       ///< at the other end; kForever: it stays
    std::optional<Box> touch;          ///< the player in here sets it off
    std::vector<std::int32_t> starts;  ///< movers that it sets off in turn (a button)

    static constexpr std::int32_t kForever = -1;
};

/// A volume that does something to the player who enters it.
struct Trigger {
    Box box;
    bool ends_level = false;
    std::vector<std::int32_t> starts;  ///< movers
    struct Exit {
        Place place;
        Angle yaw;
    };
    std::optional<Exit> teleports_to;
};

/// All of a level that the game needs and that never changes.
struct Stage {
    const Level* level = nullptr;  ///< outlives the stage
    std::vector<Mover> movers;
    std::vector<Trigger> triggers;
    std::vector<ModelIndex> still_models;        ///< brush models that are seen and never move
    std::vector<ModelIndex> solid_still_models;  ///< those of them that stop the player
    Place player_start;
    Angle player_yaw;
    std::string end_message;  ///< what the level says at its end; may be empty
};

/// Reads entities: info_player_start, func_door, func_plat, func_button, trigger_once, trigger_multiple,
/// trigger_teleport, trigger_changelevel; any other func_ stands still. Keys that are no numbers count as absent.
Stage make_stage(const Level& level);

/// The state in which a level begins.
GameState start_of(const Stage& stage);

/// Where a mover's model stands, as an offset.
Place offset_of(const Mover& mover, const MoverState& state);

}  // namespace oblong

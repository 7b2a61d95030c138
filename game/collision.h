#pragma once

#include <cstdint>

#include "game/stage.h"
#include "game/state.h"

namespace oblong {

/// How far the player's box gets on a straight way.
struct Contact {
    Place end;              ///< where it stops, clear of what it hit
    bool has_hit = false;   ///< it stops before the way's end
    Vec3<Unit> normal;      ///< of what it hit, towards the player
    ModelIndex model;       ///< that it hit
    bool is_stuck = false;  ///< the whole way is inside something solid
};

/// Moves the player's box through the world and all movers where they stand now (hull 1).
Contact move_box(const Stage& stage, const GameState& state, const Place& from, const Place& to);

/// True where the player's box at a place touches nothing solid.
bool is_free(const Stage& stage, const GameState& state, const Place& place);

/// What fills the world at a point (contents::kEmpty and so on).
std::int32_t contents_at(const Stage& stage, const Place& point);

}  // namespace oblong

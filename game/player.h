#pragma once

#include "game/stage.h"
#include "game/state.h"
#include "game/tick_input.h"

namespace oblong {

/// The eye above Player::place.
inline constexpr std::int32_t kEyeHeight = 22;

/// Moves the player by a tick, as Quake does: walks, climbs steps of up to 18 units, jumps, falls, swims. Integers
/// only.
void step_player(const Stage& stage, GameState& state, const TickInput& input);

}  // namespace oblong

#pragma once

#include "game/stage.h"
#include "game/state.h"

namespace oblong {

/// Sets a mover off, and those that it sets off: one at rest leaves, one on its way back turns round, one at its other
/// end waits anew.
void set_off(const Stage& stage, GameState& state, std::int32_t mover);

/// Sets off the movers whose touch box the player is in.
void touch_movers(const Stage& stage, GameState& state);

/// Moves all movers by a tick. They carry and push the player; one that would crush the player turns round.
void step_movers(const Stage& stage, GameState& state);

}  // namespace oblong

#pragma once

#include <cstdint>

#include "game/simulation/activations.h"
#include "game/simulation/game_level.h"
#include "game/simulation/state.h"
#include "game/simulation/tick_input.h"

namespace oblong {

/// The eye above Player::position.
inline constexpr std::int32_t kEyeHeight = 22;
Position eye_of(const Player& player);

/// Whether the player's way within a tick is too long for a motion.
bool was_teleported(const Player& before, const Player& after);

/// A player who is farther out along an axis, outside any level, comes in again.
inline constexpr World kFarthestPlayer = World::from_int(40'000);

/// Moves the game by one tick of 1/35 s. Reads nothing but its arguments: the same inputs give the same states on
/// every machine, at every frame rate of the display. Its work is bounded, whatever the level; what is left goes on in
/// the next ticks.
TickReport step(const GameLevel& level, GameState& state, const TickInput& input);

// The parts of a tick, in their order.

/// Moves the active movers. They carry and push the player; one that has no room to push turns back or waits.
void step_movers(const GameLevel& level, GameState& state, Activations& activations);

/// Puts the list of active movers in order, after all that may have set some off or removed them.
void end_tick_of_movers(GameState& state);

/// Moves the player as Quake does: walks, climbs steps of up to 18 units, jumps, falls, swims.
void step_player(const GameLevel& level, GameState& state, const TickInput& input);

/// What movers do whose touch box the player is in.
void touch_movers(const GameLevel& level, GameState& state, Activations& activations);

/// Takes the items that the player touches.
void touch_items(const GameLevel& level, GameState& state, Activations& activations);

/// What triggers do that the player is in.
void touch_triggers(const GameLevel& level, GameState& state, Activations& activations);

// What Activations do to one entity.

void activate_mover(const GameLevel& level, GameState& state, std::uint32_t mover, Activations& activations);
void activate_trigger(const GameLevel& level, GameState& state, std::uint32_t trigger, Activations& activations);

}  // namespace oblong

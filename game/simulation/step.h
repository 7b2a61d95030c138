#pragma once

#include <algorithm>
#include <cstdint>

#include "game/simulation/activations.h"
#include "game/simulation/game_level.h"
#include "game/simulation/state.h"
#include "game/simulation/tick.h"

namespace oblong {

/// The eye above Player::position.
inline constexpr std::int32_t kEyeHeight = 22;
Position eye_of(const Player& player);

/// True if the player moved further in a tick than any motion leads.
bool was_teleported(const Player& before, const Player& after);

/// A player farther out along an axis is outside any level, and respawns.
inline constexpr World kFarthestPlayer = World::from_int(40'000);

/// Moves the game by one tick of 1/35 s. Reads nothing but its arguments: the same inputs give the same states on every
/// machine, at every frame rate of the display. Its work is bounded, whatever the level; what exceeds the bounds
/// continues in the next ticks.
TickReport step(const GameLevel& level, GameState& state, const TickInput& input);

// The parts of a tick, in their order.

/// Moves the active movers. They carry and push the player; a mover that has no room to push turns back or waits.
void step_movers(const GameLevel& level, GameState& state, Activations& activations);

/// Sorts the list of active movers, after others have started or removed movers.
void end_tick_of_movers(GameState& state);

/// Moves the player as Quake does: walks, climbs steps of up to 18 units and ladders, jumps, falls, swims.
void step_player(const GameLevel& level, GameState& state, const TickInput& input);

/// Handles the touch boxes of movers that the player is in.
void touch_movers(const GameLevel& level, GameState& state, Activations& activations);

/// Takes the items that the player touches.
void touch_items(const GameLevel& level, GameState& state, Activations& activations);

/// Takes health, where the level's player has any.
inline void hurt(const GameLevel& level, GameState& state, std::int32_t damage) {
    state.harm.damage = std::min(level.health, state.harm.damage + damage);
}

/// Lava and slime hurt by how deep the player is in them, as Quake's: lava 10 to 30 each fifth of a second, slime 4 to
/// 12 each second.
void hurt_in_liquid(const GameLevel& level, GameState& state);

/// Fires the timers that are due.
void run_timers(const GameLevel& level, GameState& state, Activations& activations);

/// Whether the player is in a ladder, and looks its way.
bool is_on_ladder(const GameLevel& level, const GameState& state);

/// Handles the triggers that the player is in.
void touch_triggers(const GameLevel& level, GameState& state, const TickInput& input, Activations& activations);

// How Activations activate one entity.

void activate_mover(const GameLevel& level, GameState& state, std::uint32_t mover, Activations& activations);
void activate_trigger(const GameLevel& level, GameState& state, std::uint32_t trigger, Activations& activations);

}  // namespace oblong

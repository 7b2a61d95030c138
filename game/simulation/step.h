#pragma once

#include <cstdint>
#include <span>

#include "game/simulation/game_level.h"
#include "game/simulation/state.h"
#include "game/simulation/tick_input.h"

namespace oblong {

/// The eye above Player::position.
inline constexpr std::int32_t kEyeHeight = 22;

/// A player who is farther out along an axis, outside any level, comes in again.
inline constexpr World kFarthestPlayer = World::from_int(40'000);

/// Moves the game by one tick of 1/35 s. Reads nothing but its arguments: the same inputs give the same states on
/// every machine, at every frame rate of the display.
void step(const GameLevel& level, GameState& state, const TickInput& input);

// The parts of a tick, in their order.

/// Moves the active movers. They carry and push the player; one that has no room to push turns back.
void step_movers(const GameLevel& level, GameState& state);

/// Moves the player as Quake does: walks, climbs steps of up to 18 units, jumps, falls, swims.
void step_player(const GameLevel& level, GameState& state, const TickInput& input);

/// Activates the movers whose touch box the player is in.
void touch_movers(const GameLevel& level, GameState& state);

/// Takes the items that the player touches.
void touch_items(const GameLevel& level, GameState& state);

/// Activates what an entity fires, and shows its message.
void fire(const GameLevel& level, GameState& state, const Firing& firing);

/// Activates movers and what they target: one at rest leaves, one on its way back turns round, one at its other end
/// restarts its wait. Lights that they target are switched by those that leave their start.
void activate(const GameLevel& level, GameState& state, std::span<const std::uint32_t> movers);

/// Switches a target's lights: on if they are off, else off.
void switch_lights(const Target& target, GameState& state);

/// Activates teleporters: they work for 0.2 s from now on.
void activate_teleporters(const Target& target, GameState& state);

}  // namespace oblong

#pragma once

#include "game/simulation/collision.h"
#include "game/simulation/game_level.h"
#include "game/simulation/state.h"

namespace oblong {

/// The least z of the normal of a surface that can be stood upon: up to 45.6 degrees, Quake's 0.7.
inline constexpr Unit kGroundNormalZ = Unit::from_raw(751'619'277);
inline constexpr std::int32_t kStepHeight = 18;

/// A player's position and velocity.
struct Motion {
    Position position;
    Velocity velocity;
};

/// Straight motion for a tick, which slides along what it hits, up to four times.
Motion slide_move(const GameLevel& level, const GameState& state, const Motion& motion);

/// The same for a walking player: climbs steps of up to kStepHeight if that leads further.
Motion step_slide_move(const GameLevel& level, const GameState& state, const Motion& motion);

/// The ground within `reach` units below a position: where the box stands, and the model. Contact::has_hit is false if
/// there is none, or if it is too steep.
Contact find_ground(const GameLevel& level, const GameState& state, const Position& position, World reach);

}  // namespace oblong

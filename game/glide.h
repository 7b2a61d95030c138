#pragma once

#include "game/collision.h"
#include "game/stage.h"
#include "game/state.h"

namespace oblong {

/// Surfaces at least as level as this (the normal's z) can be stood upon: up to 45.6 degrees, Quake's 0.7.
inline constexpr Unit kLevelEnough = Unit::from_raw(751'619'277);
inline constexpr std::int32_t kStepHeight = 18;

/// A player's place and velocity, on their own.
struct Motion {
    Place place;
    Velocity velocity;
};

/// A tick of straight motion that slides along what it hits, up to four times.
Motion glide(const Stage& stage, const GameState& state, const Motion& motion);

/// The same for one who walks: climbs what is no higher than a step where that leads further.
Motion glide_over_steps(const Stage& stage, const GameState& state, const Motion& motion);

/// The ground within `reach` units below a place: where the box stands on it, and the model; Contact::has_hit is false
/// where there is none that is level enough.
Contact find_ground(const Stage& stage, const GameState& state, const Place& place, World reach);

}  // namespace oblong

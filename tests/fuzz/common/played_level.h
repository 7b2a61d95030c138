#pragma once

#include "engine/level/level.h"
#include "engine/mesh/mesh.h"
#include "engine/surface/palette.h"
#include "game/simulation/game_level.h"
#include "tests/fuzz/common/fuzz.h"

namespace oblong::fuzz {

/// A palette of greys.
const Palette& greys();

/// Plays a level for some ticks, with inputs that `seed` decides, and draws small pictures of it before and after:
/// every pixel is written by one face at most, pictures drawn again are the same, states are such as a save may hold.
void play_and_draw(const Level& level, std::uint64_t seed);

/// Plays on from a state of the level.
void play(const GameLevel& level, GameState& state, int ticks, std::uint64_t seed);
/// That a save could hold the state, and what it reads back is the same.
void check_state(const GameLevel& level, const GameState& state);

/// stage.map, compiled, which has one of most things.
const Level& stage_level();

/// Draws a mesh of any numbers in stage_level(), twice the same.
void draw_in_stage(const Mesh& mesh, std::uint64_t seed);

}  // namespace oblong::fuzz

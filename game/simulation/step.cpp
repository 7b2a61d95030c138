#include "game/simulation/step.h"

#include "game/simulation/collision.h"

namespace oblong {
namespace {

void respawn(GameState& state) {
    const bool holds_jump = state.player.holds_jump;
    state.player = {};
    state.player.position = state.progress.respawn.position;
    state.player.yaw = state.progress.respawn.yaw;
    state.player.holds_jump = holds_jump;
}

// A player who falls out of a level that leaks respawns.
void respawn_outside(GameState& state) {
    const Position& at = state.player.position;
    const auto is_outside = [](World w) { return w > kFarthestPlayer || w < -kFarthestPlayer; };
    if (is_outside(at.x) || is_outside(at.y) || is_outside(at.z)) respawn(state);
}

}  // namespace

TickReport step(const GameLevel& level, GameState& state, const TickInput& input) {
    ++state.tick;
    if (state.has_ended) return {};
    Activations activations(level, state);
    if ((input.buttons & kRespawnButton) != 0) respawn(state);
    activations.begin_tick();
    step_movers(level, state, activations);
    activations.report().has_left_obstacles = has_too_many_obstacles(level, state.player.position);
    step_player(level, state, input);
    respawn_outside(state);
    touch_movers(level, state, activations);
    touch_items(level, state, activations);
    touch_triggers(level, state, activations);
    activations.end_tick();
    end_tick_of_movers(state);
    return activations.report();
}

}  // namespace oblong

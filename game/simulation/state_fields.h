#pragma once

#include <type_traits>

#include "game/simulation/state.h"

namespace oblong {

/// Visits every field of a state, in one order that the hash and saved games share: visit(field) for each number
/// (integers, enumerations, bool, World, Angle), visit(vector) for each list. What is not visited here is neither
/// hashed nor saved. State is GameState or const GameState.
template <class State, class Visit>
requires std::is_same_v<std::remove_const_t<State>, GameState>
void visit_fields(State& state, Visit& visit) {
    const auto visit_all = [&](auto&... fields) { (visit(fields), ...); };
    auto& player = state.player;
    visit_all(state.tick);
    visit_all(player.position.x, player.position.y, player.position.z);
    visit_all(player.velocity.x, player.velocity.y, player.velocity.z);
    visit_all(player.yaw, player.pitch, player.eye_lag, player.ground, player.depth, player.holds_jump);
    visit_all(state.movers, state.active_movers, state.teleporter_ends, state.dark_styles, state.touched_switches);
    visit_all(state.items, state.keys, state.respawn.position.x, state.respawn.position.y, state.respawn.position.z,
              state.respawn.yaw, state.shown_message, state.message_tick, state.has_ended, state.exit);
}

/// The same of a mover: MoverState or const MoverState.
template <class Mover, class Visit>
requires std::is_same_v<std::remove_const_t<Mover>, MoverState>
void visit_fields(Mover& mover, Visit& visit) {
    visit(mover.phase);
    visit(mover.travelled);
    visit(mover.wait_ticks);
}

}  // namespace oblong

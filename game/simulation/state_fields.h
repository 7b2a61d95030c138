#pragma once

#include <type_traits>

#include "game/simulation/state.h"

namespace oblong {

/// Visits every field of a state, in one order that the hash and saved games share: visit(field) for each number
/// (integers, enumerations, bool, World, Angle), visit(vector) for each list. Structs in lists have their own
/// visit_fields() below. A field that is not visited here is neither hashed nor saved. State is GameState or const
/// GameState.
template <class State, class Visit>
requires std::is_same_v<std::remove_const_t<State>, GameState>
void visit_fields(State& state, Visit& visit) {
    const auto visit_all = [&](auto&... fields) { (visit(fields), ...); };
    auto& player = state.player;
    visit_all(state.tick);
    visit_all(player.position.x, player.position.y, player.position.z);
    visit_all(player.velocity.x, player.velocity.y, player.velocity.z);
    visit_all(player.yaw, player.pitch, player.eye_lag, player.ground, player.depth, player.holds_jump);
    visit_all(state.movers, state.active_movers, state.walls, state.triggers, state.items, state.delayed);
    visit_all(state.dark_styles, state.progress.found_secrets, state.progress.keys);
    visit_all(state.progress.respawn.position.x, state.progress.respawn.position.y, state.progress.respawn.position.z,
              state.progress.respawn.yaw);
    visit_all(state.message.shown, state.message.tick, state.has_ended, state.exit, state.backlog);
}

/// The same for a mover: MoverState or const MoverState.
template <class Mover, class Visit>
requires std::is_same_v<std::remove_const_t<Mover>, MoverState>
void visit_fields(Mover& mover, Visit& visit) {
    visit(mover.phase);
    visit(mover.leg);
    visit(mover.travelled);
    visit(mover.wait_ticks);
    visit(mover.next_touch);
    visit(mover.has_been_fired);
}

template <class Trigger, class Visit>
requires std::is_same_v<std::remove_const_t<Trigger>, TriggerState>
void visit_fields(Trigger& trigger, Visit& visit) {
    visit(trigger.ready_tick);
    visit(trigger.open_until);
    visit(trigger.left);
}

template <class Delayed, class Visit>
requires std::is_same_v<std::remove_const_t<Delayed>, DelayedFiring>
void visit_fields(Delayed& delayed, Visit& visit) {
    visit(delayed.tick);
    visit(delayed.by.kind);
    visit(delayed.by.index);
}

template <class Waiting, class Visit>
requires std::is_same_v<std::remove_const_t<Waiting>, WaitingFiring>
void visit_fields(Waiting& waiting, Visit& visit) {
    visit(waiting.target);
    visit(waiting.next);
    visit(waiting.removes);
}

template <class Log, class Visit>
requires std::is_same_v<std::remove_const_t<Log>, Backlog>
void visit_fields(Log& backlog, Visit& visit) {
    visit(backlog.waiting);
    visit(backlog.next_mover);
    visit(backlog.next_touch_box);
    visit(backlog.next_trigger_box);
    visit(backlog.next_item_box);
}

}  // namespace oblong

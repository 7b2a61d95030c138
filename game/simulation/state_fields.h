#pragma once

#include <tuple>
#include <type_traits>

#include "game/simulation/state.h"

namespace oblong {

template <class Field, class Struct>
concept MaybeConst = std::is_same_v<std::remove_const_t<Field>, Struct>;

// fields_of(): references to every field of a state, in one order that the hash and saved games share: numbers
// (integers, enumerations, bool, World, Angle), lists, and structs with their own fields_of(). A field that is not here
// is neither hashed nor saved.

auto fields_of(MaybeConst<GameState> auto& state) {
    auto& player = state.player;
    auto& respawn = state.progress.respawn;
    return std::tie(state.tick, player.position.x, player.position.y, player.position.z, player.velocity.x,
                    player.velocity.y, player.velocity.z, player.yaw, player.pitch, player.eye_lag, player.ground,
                    player.depth, player.holds_jump, state.movers, state.active_movers, state.walls, state.triggers,
                    state.items, state.delayed, state.dark_styles, state.progress.found_secrets, state.progress.keys,
                    respawn.position.x, respawn.position.y, respawn.position.z, respawn.yaw, state.message.shown,
                    state.message.tick, state.has_ended, state.exit, state.backlog);
}

auto fields_of(MaybeConst<MoverState> auto& mover) {
    return std::tie(mover.phase, mover.leg, mover.travelled, mover.wait_ticks, mover.next_touch, mover.has_been_fired);
}

auto fields_of(MaybeConst<TriggerState> auto& trigger) {
    return std::tie(trigger.ready_tick, trigger.open_until, trigger.left);
}

auto fields_of(MaybeConst<DelayedFiring> auto& delayed) {
    return std::tie(delayed.tick, delayed.by.kind, delayed.by.index);
}

auto fields_of(MaybeConst<WaitingFiring> auto& waiting) {
    return std::tie(waiting.target, waiting.next, waiting.removes);
}

auto fields_of(MaybeConst<Backlog> auto& backlog) {
    return std::tie(backlog.waiting, backlog.next_mover, backlog.next_touch_box, backlog.next_trigger_box,
                    backlog.next_item_box);
}

template <class Struct>
concept HasFields = requires(Struct& each) {
    fields_of(each);
};

/// Calls visit(field) for each.
void visit_fields(HasFields auto& each, auto& visit) {
    std::apply([&](auto&... fields) { (visit(fields), ...); }, fields_of(each));
}

}  // namespace oblong

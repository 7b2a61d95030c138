#include "game/simulation/step.h"

#include <algorithm>
#include <set>

#include "engine/fixed/trig.h"

namespace oblong {
namespace {

constexpr World kExitSpeed = World::from_int(300);

void teleport(GameState& state, const Place& exit) {
    Player& player = state.player;
    state.respawn = exit;
    player.position = exit.position;
    player.yaw = exit.yaw;
    player.pitch = 0;
    player.velocity = times(kExitSpeed, {cosine(exit.yaw), sine(exit.yaw), Unit{}});
    player.ground = Player::kNoGround;
}

void end_level(GameState& state, std::uint32_t trigger) {
    if (state.has_ended) return;
    state.has_ended = true;
    state.exit = static_cast<std::int32_t>(trigger);
}

bool teleports(const Trigger& trigger, const GameState& state) {
    if (!trigger.teleports_to) return false;
    return !trigger.activation || state.tick < state.teleporter_ends[*trigger.activation];
}

// Each target is activated once, however many triggers name it.
void activate_targets(const GameLevel& level, GameState& state, const std::set<TargetIndex>& targets) {
    std::vector<std::uint32_t> movers;
    for (const TargetIndex index : targets) {
        const Target& target = level.target(index);
        movers.insert(movers.end(), target.movers.begin(), target.movers.end());
        activate_teleporters(target, state);
    }
    activate(level, state, movers);
}

// The triggers that the player is in, in their order. One that teleports the player ends those at the old place.
std::vector<std::uint32_t> enter_triggers(const GameLevel& level, GameState& state) {
    std::vector<std::uint32_t> entered;
    const auto is_later = [&](std::uint32_t i) { return entered.empty() || i > entered.back(); };
    for (bool is_moved = true; is_moved;) {
        is_moved = false;
        for (const std::uint32_t i : level.trigger_boxes.overlapping(player_box(state.player.position))) {
            const Trigger& trigger = level.triggers[i];
            if (!is_later(i) || !trigger.box.overlaps(player_box(state.player.position))) continue;
            entered.push_back(i);
            if (trigger.ends_level) end_level(state, i);
            is_moved = teleports(trigger, state);
            if (!is_moved) continue;
            teleport(state, *trigger.teleports_to);
            break;
        }
    }
    return entered;
}

// Each target's lights are switched once, however many triggers name it, when the player enters one of them.
void enter_switches(const GameLevel& level, GameState& state, const std::vector<std::uint32_t>& entered) {
    std::vector<std::uint32_t>& touched = state.touched_switches;
    std::set<TargetIndex> switched;
    std::erase_if(touched, [&](std::uint32_t i) {
        return !level.triggers[i].switches_once && !std::binary_search(entered.begin(), entered.end(), i);
    });
    for (const std::uint32_t i : entered) {
        const TargetIndex target = level.triggers[i].target;
        if (target == kNoTarget || level.target(target).light_styles == 0) continue;
        const auto place = std::lower_bound(touched.begin(), touched.end(), i);
        if (place != touched.end() && *place == i) continue;
        touched.insert(place, i);
        switched.insert(target);
    }
    for (const TargetIndex target : switched) switch_lights(level.target(target), state);
}

void touch_triggers(const GameLevel& level, GameState& state) {
    const std::vector<std::uint32_t> entered = enter_triggers(level, state);
    std::set<TargetIndex> targets;
    for (const std::uint32_t i : entered)
        if (level.triggers[i].target != kNoTarget) targets.insert(level.triggers[i].target);
    activate_targets(level, state, targets);
    enter_switches(level, state, entered);
}

void respawn(GameState& state) {
    const Player before = state.player;
    state.player = {};
    state.player.position = state.respawn.position;
    state.player.yaw = state.respawn.yaw;
    state.player.holds_jump = before.holds_jump;
}

// A player who falls out of a level that leaks comes in again.
void respawn_outside(GameState& state) {
    const Player& player = state.player;
    const auto is_outside = [](World w) { return w > kFarthestPlayer || w < -kFarthestPlayer; };
    if (!is_outside(player.position.x) && !is_outside(player.position.y) && !is_outside(player.position.z)) return;
    respawn(state);
}

}  // namespace

void fire(const GameLevel& level, GameState& state, const Firing& firing) {
    if (firing.message != kNoMessage) {
        state.shown_message = firing.message;
        state.message_tick = state.tick;
    }
    if (firing.target == kNoTarget) return;
    activate_targets(level, state, {firing.target});
    switch_lights(level.target(firing.target), state);
}

void step(const GameLevel& level, GameState& state, const TickInput& input) {
    ++state.tick;
    if (state.has_ended) return;
    if ((input.buttons & kRespawnButton) != 0) respawn(state);
    step_movers(level, state);
    step_player(level, state, input);
    respawn_outside(state);
    touch_movers(level, state);
    touch_items(level, state);
    touch_triggers(level, state);
}

}  // namespace oblong

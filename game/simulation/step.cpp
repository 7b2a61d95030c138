#include "game/simulation/step.h"

#include <algorithm>
#include <set>

#include "engine/fixed/trig.h"

namespace oblong {
namespace {

constexpr World kExitSpeed = World::from_int(300);
constexpr World kFarthest = World::from_int(40'000);

void teleport(Player& player, const Trigger::Exit& exit) {
    player.position = exit.position;
    player.yaw = exit.yaw;
    player.pitch = 0;
    player.velocity = times(kExitSpeed, {cosine(exit.yaw), sine(exit.yaw), Unit{}});
    player.ground = Player::kNoGround;
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
            state.has_ended |= trigger.ends_level;
            is_moved = teleports(trigger, state);
            if (!is_moved) continue;
            teleport(state.player, *trigger.teleports_to);
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

// A player who falls out of a level that leaks starts again.
void restart_outside(const GameLevel& level, Player& player) {
    const auto is_outside = [](World w) { return w > kFarthest || w < -kFarthest; };
    if (!is_outside(player.position.x) && !is_outside(player.position.y) && !is_outside(player.position.z)) return;
    player = start_of(level).player;
}

}  // namespace

void step(const GameLevel& level, GameState& state, const TickInput& input) {
    ++state.tick;
    if (state.has_ended) return;
    step_movers(level, state);
    step_player(level, state, input);
    restart_outside(level, state.player);
    touch_movers(level, state);
    touch_triggers(level, state);
}

}  // namespace oblong

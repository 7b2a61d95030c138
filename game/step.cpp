#include "game/step.h"

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
    return !trigger.activation || state.teleporter_ticks[*trigger.activation] > 0;
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

void touch_triggers(const GameLevel& level, GameState& state) {
    std::set<TargetIndex> targets;
    for (const Trigger& trigger : level.triggers) {
        if (!trigger.box.overlaps(player_box(state.player.position))) continue;
        state.has_ended |= trigger.ends_level;
        if (trigger.target != kNoTarget) targets.insert(trigger.target);
        if (teleports(trigger, state)) teleport(state.player, *trigger.teleports_to);
    }
    activate_targets(level, state, targets);
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
    for (std::int32_t& ticks : state.teleporter_ticks) ticks = std::max(ticks - 1, 0);
    step_movers(level, state);
    step_player(level, state, input);
    restart_outside(level, state.player);
    touch_movers(level, state);
    touch_triggers(level, state);
}

}  // namespace oblong

#include "game/simulation/step.h"

#include <array>
#include <utility>

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

void visit(const GameLevel& level, Activations& activations) {
    if (level.visit == kNoTarget) return;
    for (const EntityRef& entity : level.target(level.visit).entities) activations.activate(entity);
}

// A player who falls out of a level that leaks respawns.
void respawn_outside(GameState& state) {
    if (!is_within(state.player.position, kFarthestPlayer)) respawn(state);
}

// Back to the last checkpoint, with all health; before any, the walk is lost.
void die(const GameLevel& level, GameState& state) {
    state.has_ended = state.progress.respawn == level.start;
    if (state.has_ended) return;
    respawn(state);
    state.harm = {};
    show(state, level.died);
}

}  // namespace

TickReport step(const GameLevel& level, GameState& state, const TickInput& input) {
    ++state.tick;
    if (state.has_ended) return {};
    Activations activations(level, state);
    if ((input.buttons & kRespawnButton) != 0) respawn(state);
    activations.begin_tick();
    run_timers(level, state, activations);
    if ((input.buttons & kVisitButton) != 0) visit(level, activations);
    step_movers(level, state, activations);
    activations.report().has_left_obstacles = has_too_many_obstacles(level, state.player.position);
    step_player(level, state, input);
    if (level.health != 0) hurt_in_liquid(level, state);
    respawn_outside(state);
    touch_movers(level, state, activations);
    touch_items(level, state, activations);
    touch_triggers(level, state, input, activations);
    if (level.health != 0 && state.harm.damage == level.health && !state.has_ended) die(level, state);
    activations.end_tick();
    end_tick_of_movers(state);
    return activations.report();
}

std::vector<std::string_view> TickReport::left() const {
    const std::array<std::pair<bool, std::string_view>, 5> kinds{{
        {has_left_activations, "activations wait for later ticks"},
        {has_dropped_firings, "activations beyond 16,384 that wait are dropped"},
        {has_left_movers, "movers wait for later ticks"},
        {has_left_touches, "triggers and items are touched in later ticks"},
        {has_left_obstacles, "brush models beyond 256 in one place are not solid"},
    }};
    std::vector<std::string_view> texts;
    for (const auto& [is_left, text] : kinds)
        if (is_left) texts.push_back(text);
    return texts;
}

}  // namespace oblong

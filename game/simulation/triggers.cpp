#include <algorithm>

#include "engine/base/checksum.h"
#include "engine/fixed/trig.h"
#include "game/simulation/items.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

using Phase = MoverState::Phase;

constexpr World kExitSpeed = World::from_int(300);
constexpr std::int64_t kTeleporterTicks = kTicksPerSecond / 5;

EntityRef trigger_ref(std::uint32_t trigger) {
    return {EntityRef::Kind::Trigger, trigger};
}

bool is_gone(const TriggerState& state) {
    return state.ready_tick == TriggerState::kNever;
}

void begin_wait(const Trigger& trigger, GameState& state, std::uint32_t i) {
    state.triggers[i].ready_tick =
        trigger.wait_ticks == kForever ? TriggerState::kNever : state.tick + trigger.wait_ticks;
}

void fire_unless_waiting(const Trigger& trigger, GameState& state, std::uint32_t i, Activations& activations) {
    if (state.tick < state.triggers[i].ready_tick) return;
    begin_wait(trigger, state, i);
    state.progress.found_secrets += trigger.is_secret;
    if (trigger.breaks) item(state.walls, *trigger.breaks) = WallState::Removed;
    activations.fire(trigger_ref(i));
}

void count_down(const GameLevel& level, GameState& state, std::uint32_t i, Activations& activations) {
    const Trigger& trigger = level.triggers[i];
    const std::int32_t left = --state.triggers[i].left;
    if (!trigger.is_quiet) {
        const auto most = static_cast<std::int32_t>(level.counter_messages.size()) - 1;
        show(state, item(level.counter_messages, std::min(left, most)));
    }
    if (left == 0) fire_unless_waiting(trigger, state, i, activations);
}

// Strikes Chthon: counts only while both electrodes are in place; the last stroke fires the trigger.
void strike(const GameLevel& level, GameState& state, std::uint32_t i, Activations& activations) {
    const Trigger& trigger = level.triggers[i];
    if (trigger.electrodes.size() < 2 || state.triggers[i].left == 0) return;
    for (const std::uint32_t electrode : trigger.electrodes)
        if (state.movers[electrode].phase != Phase::AtEnd) return;
    if (--state.triggers[i].left == 0) activations.fire(trigger_ref(i));
}

bool looks_along(const Player& player, const Vec3<Unit>& direction) {
    const World ahead = times(times(World::from_int(1), cosine(player.yaw)), direction.x) +
                        times(times(World::from_int(1), sine(player.yaw)), direction.y);
    return ahead >= World{};
}

bool meets(const ViewCondition& wanted, const Player& player, const TickInput& input) {
    for (std::size_t i = 0; i < kViewDials; ++i)
        if (wanted.dials[i].value_or(input.view[i]) != input.view[i]) return false;
    if (wanted.asks_for_work() && (input.work == 0 || input.work < wanted.least_work || input.work > wanted.most_work))
        return false;
    if (!wanted.point && !wanted.direction) return true;
    const Vec3<Unit> look = direction_of(player.yaw, Angle::from_bam(player.pitch)),
                     way = wanted.point ? normalised(*wanted.point - eye_of(player)) : *wanted.direction;
    return convert<Unit>(dot(way, look)) >= wanted.least_cosine;
}

bool may_fire(const Trigger& trigger, const Player& player, const TickInput& input) {
    return (!trigger.facing || looks_along(player, *trigger.facing)) &&
           (!trigger.view || meets(*trigger.view, player, input));
}

void teleport(GameState& state, const Place& exit) {
    Player& player = state.player;
    state.progress.respawn = exit;
    player.position = exit.position;
    player.yaw = exit.yaw;
    player.pitch = 0;
    player.velocity = times(kExitSpeed, {cosine(exit.yaw), sine(exit.yaw), Unit{}});
    player.ground = Player::kNoGround;
}

void end_level(GameState& state, std::uint32_t trigger) {
    state.has_ended = true;
    state.exit = static_cast<std::int32_t>(trigger);
}

void hurt_by(const GameLevel& level, GameState& state, std::uint32_t i, Activations& activations) {
    if (state.triggers[i].left == 0 || state.tick < state.triggers[i].ready_tick) return;
    begin_wait(level.triggers[i], state, i);
    hurt(level, state, level.triggers[i].damage);
    activations.fire(trigger_ref(i));
}

// A timer's wait, the same on every machine: what varies depends on the tick and the timer alone.
std::int64_t wait_of(const Trigger& timer, std::int64_t tick, std::uint32_t i) {
    Fnv1a hash;
    hash.add_number(static_cast<std::uint64_t>(tick));
    hash.add_number(i);
    const std::int64_t random = timer.random_ticks;
    const auto any = static_cast<std::int64_t>(hash.value() >> 32);
    return std::max<std::int64_t>(1, timer.wait_ticks - random + any % (2 * random + 1));
}

void push(const Trigger& trigger, GameState& state, std::uint32_t i) {
    state.player.velocity = trigger.push;
    if (trigger.wait_ticks == kForever) begin_wait(trigger, state, i);
}

// True if the player was teleported.
bool touch(const GameLevel& level, GameState& state, const TickInput& input, std::uint32_t i,
           Activations& activations) {
    const Trigger& trigger = level.triggers[i];
    switch (trigger.kind) {
        case TriggerKind::Multiple:
            if (has_lenses(level, state, trigger.lenses) && may_fire(trigger, state.player, input))
                fire_unless_waiting(trigger, state, i, activations);
            return false;
        case TriggerKind::Hurt:
            hurt_by(level, state, i, activations);
            return false;
        case TriggerKind::Teleport:
            if (trigger.needs_activation && state.tick >= state.triggers[i].open_until) return false;
            activations.fire(trigger_ref(i));
            teleport(state, trigger.place);
            return true;
        case TriggerKind::Push:
            push(trigger, state, i);
            return false;
        case TriggerKind::Checkpoint:
            state.progress.respawn = trigger.place;
            return false;
        case TriggerKind::Exit:
            activations.fire(trigger_ref(i));
            end_level(state, i);
            return false;
        case TriggerKind::Relay:
        case TriggerKind::Counter:
        case TriggerKind::Lightning:
        case TriggerKind::Timer:
        case TriggerKind::Ladder:
            return false;
    }
    return false;
}

}  // namespace

void run_timers(const GameLevel& level, GameState& state, Activations& activations) {
    for (const std::uint32_t i : level.timers) {
        TriggerState& timer = state.triggers[i];
        if (timer.left == 0 || state.tick < timer.ready_tick) continue;
        timer.ready_tick = state.tick + wait_of(level.triggers[i], state.tick, i);
        activations.fire(trigger_ref(i));
    }
}

bool is_on_ladder(const GameLevel& level, const GameState& state) {
    const Box player = player_box(state.player.position);
    return std::any_of(level.ladders.begin(), level.ladders.end(), [&](std::uint32_t i) {
        const Trigger& ladder = level.triggers[i];
        return !is_gone(state.triggers[i]) && ladder.box->overlaps(player) &&
               (!ladder.facing || looks_along(state.player, *ladder.facing));
    });
}

// In their order. After a teleport, those at the old place are skipped.
void touch_triggers(const GameLevel& level, GameState& state, const TickInput& input, Activations& activations) {
    std::uint32_t first = 0;
    std::int32_t teleports = 0;
    for (bool is_moved = true; is_moved && teleports <= TickReport::kMostTeleports; ++teleports) {
        is_moved = false;
        const Box player = player_box(state.player.position);
        for (const std::uint32_t i :
             activations.touched(level.boxes.triggers, player, state.backlog.next_trigger_box)) {
            if (i < first || is_gone(state.triggers[i]) || !level.triggers[i].box->overlaps(player)) continue;
            first = i + 1;
            is_moved = touch(level, state, input, i, activations);
            if (state.has_ended) return;
            if (!is_moved) continue;
            state.backlog.next_trigger_box = 0;
            break;
        }
    }
    activations.report().has_left_touches |= teleports > TickReport::kMostTeleports;
}

void activate_trigger(const GameLevel& level, GameState& state, std::uint32_t i, Activations& activations) {
    const Trigger& trigger = level.triggers[i];
    if (is_gone(state.triggers[i]) || !has_lenses(level, state, trigger.lenses)) return;
    switch (trigger.kind) {
        case TriggerKind::Multiple:
            return fire_unless_waiting(trigger, state, i, activations);
        case TriggerKind::Relay:
            return activations.fire(trigger_ref(i));
        case TriggerKind::Counter:
            return count_down(level, state, i, activations);
        case TriggerKind::Lightning:
            return strike(level, state, i, activations);
        case TriggerKind::Teleport:
            state.triggers[i].open_until = state.tick + kTeleporterTicks;
            return;
        case TriggerKind::Timer:
            state.triggers[i].ready_tick = state.tick;
            [[fallthrough]];
        case TriggerKind::Hurt:
            state.triggers[i].left = 1 - state.triggers[i].left;
            return;
        case TriggerKind::Push:
        case TriggerKind::Checkpoint:
        case TriggerKind::Exit:
        case TriggerKind::Ladder:
            return;
    }
}

}  // namespace oblong

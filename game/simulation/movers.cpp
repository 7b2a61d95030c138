#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "game/simulation/collision.h"
#include "game/simulation/items.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

using Phase = MoverState::Phase;

constexpr std::int64_t kDoorRest_ticks = kTicksPerSecond;         // after a touch, until the next one counts
constexpr std::int64_t kMessageRest_ticks = 2 * kTicksPerSecond;  // likewise, of doors with a lock or a message
constexpr std::int32_t kRiderWait_ticks = kTicksPerSecond;        // of a lift at its upper end after the last touch
constexpr std::int32_t kTurn_ticks = kTicksPerSecond;             // of a secret door between its two legs

EntityRef mover_ref(std::uint32_t mover) {
    return {EntityRef::Kind::Mover, mover};
}

bool is_out(const MoverState& state) {
    return state.phase == Phase::Leaving || state.phase == Phase::AtEnd;
}

// The list of active movers is sorted once a tick.
void set_off(GameState& state, std::uint32_t i, Phase phase) {
    if (is_at_rest(state.movers[i])) state.active_movers.push_back(i);
    state.movers[i].phase = phase;
    state.movers[i].wait_ticks = 0;
}

bool is_in_order(const std::vector<std::uint32_t>& movers) {
    return std::adjacent_find(movers.begin(), movers.end(), std::greater_equal<>()) == movers.end();
}

// --- On the way ---

void reach_end(const Mover& mover, MoverState& state) {
    const bool has_another_leg = mover.kind == MoverKind::SecretDoor && state.leg + 1 < mover.legs.size();
    if (has_another_leg) {
        ++state.leg;
        state.travelled = World{};
        state.wait_ticks = kTurn_ticks;
        return;
    }
    state.phase = Phase::AtEnd;
    state.wait_ticks = mover.kind == MoverKind::Train ? mover.legs[state.leg].pause_ticks : mover.wait_ticks;
}

void reach_start(const Mover& mover, MoverState& state) {
    if (state.leg == 0) {
        state.phase = Phase::AtStart;
        return;
    }
    --state.leg;
    state.travelled = mover.legs[state.leg].length;
    state.wait_ticks = kTurn_ticks;
}

// Travels for a tick. At an end, changes the phase or goes to the next leg.
void travel(const Mover& mover, MoverState& state) {
    const World length = mover.legs[state.leg].length;
    const bool is_leaving = state.phase == Phase::Leaving;
    const World step = is_leaving ? mover.speed_per_tick : -mover.speed_per_tick;
    state.travelled = std::clamp(state.travelled + step, World{}, length);
    if (is_leaving && state.travelled == length)
        reach_end(mover, state);
    else if (!is_leaving && state.travelled == World{})
        reach_start(mover, state);
}

void begin_next_leg(const Mover& mover, MoverState& train) {
    train.leg = mover.legs[train.leg].next;
    train.travelled = World{};
}

void wait(const Mover& mover, MoverState& state) {
    if (state.wait_ticks == kForever) return;
    state.wait_ticks = std::max(0, state.wait_ticks - 1);
    if (state.wait_ticks > 0) return;
    if (mover.kind != MoverKind::Train) {
        state.phase = Phase::Returning;
        return;
    }
    state.phase = Phase::Leaving;
    begin_next_leg(mover, state);
}

// Carries or pushes the player along; false where there is no room.
bool push_player(const GameLevel& level, GameState& state, const Mover& mover, const Vec3<World>& moved) {
    const bool rides = state.player.ground == mover.model.number();
    if (!rides && is_free(level, state, state.player.position)) return true;
    if (is_free(level, state, state.player.position + moved)) {
        state.player.position = state.player.position + moved;
        return true;
    }
    return is_free(level, state, state.player.position);
}

// False if the player is in the way. Adds its work to the report.
bool move(const GameLevel& level, GameState& state, std::uint32_t i, TickReport& report) {
    const Mover& mover = level.movers[i];
    MoverState after = state.movers[i];
    travel(mover, after);
    const Vec3<World> offset = offset_of(mover, after), moved = offset - offset_of(mover, state.movers[i]);
    const Box player = player_box(state.player.position);
    const bool meets_player =
        state.player.ground == mover.model.number() || may_touch(level, mover.model, offset, player);
    constexpr std::int32_t kPositions = 4;  // of the player, at which obstacles are looked at
    if (meets_player)
        report.mover_steps +=
            kPositions * static_cast<std::int32_t>(level.boxes.obstacles.part_overlapping(player).numbers.size());
    const bool was_free = meets_player && is_free(level, state, state.player.position);
    const MoverState before = std::exchange(state.movers[i], after);
    if (!was_free || push_player(level, state, mover, moved)) return true;
    state.movers[i] = before;
    return false;
}

// True if a door starts to open again.
bool turn_back(const Mover& mover, MoverState& state) {
    if (!mover.turns_back) return false;
    state.phase = state.phase == Phase::Leaving ? Phase::Returning : Phase::Leaving;
    return mover.kind == MoverKind::Door && state.phase == Phase::Leaving;
}

// True if the mover fires now: a button reaches its end, or a door starts to open again.
bool step_mover(const GameLevel& level, GameState& state, std::uint32_t i, TickReport& report) {
    ++report.mover_steps;
    const Mover& mover = level.movers[i];
    MoverState& mover_state = state.movers[i];
    if (mover_state.phase == Phase::AtEnd) {
        wait(mover, mover_state);
        return false;
    }
    if (!is_moving(mover_state)) return false;
    if (mover_state.wait_ticks > 0) {
        --mover_state.wait_ticks;
        return false;
    }
    if (!move(level, state, i, report)) {
        if (state.tick % (mover.kind == MoverKind::Train ? kTicksPerSecond / 2 : 1) == 0)
            hurt(level, state, mover.damage);
        return turn_back(mover, mover_state);
    }
    return mover.kind == MoverKind::Button && mover_state.phase == Phase::AtEnd;
}

// --- Doors ---

void open_door(const GameLevel& level, GameState& state, std::uint32_t i, Activations& activations) {
    MoverState& door = state.movers[i];
    if (door.phase == Phase::AtEnd) door.wait_ticks = level.movers[i].wait_ticks;
    if (door.phase != Phase::AtStart && door.phase != Phase::Returning) return;
    set_off(state, i, Phase::Leaving);
    activations.fire(mover_ref(i));
}

void activate_door(const GameLevel& level, GameState& state, std::uint32_t i, Activations& activations) {
    const std::uint32_t first = level.movers[i].group;
    state.movers[first].has_been_fired = true;
    const bool closes = level.movers[first].toggles && is_out(state.movers[first]);
    for (const std::uint32_t door : level.movers[first].group_members) {
        if (!closes)
            open_door(level, state, door, activations);
        else if (is_out(state.movers[door]))
            set_off(state, door, Phase::Returning);
    }
}

void touch_open_door(const GameLevel& level, GameState& state, std::uint32_t i, Activations& activations) {
    MoverState& group = state.movers[level.movers[i].group];
    if (state.tick < group.next_touch) return;
    group.next_touch = state.tick + kDoorRest_ticks;
    activations.activate(mover_ref(i));
}

// A door that needs a key or lenses, or has a message.
void touch_shut_door(const GameLevel& level, GameState& state, std::uint32_t i, Activations& activations) {
    const Mover& door = level.movers[i];
    MoverState& group = state.movers[door.group];
    if (state.tick < group.next_touch || group.has_been_fired) return;
    group.next_touch = state.tick + kMessageRest_ticks;
    show(state, level.movers[door.group].touch.message);
    if (!door.touch.is_locked()) return;
    if ((state.progress.keys & door.touch.keys) != door.touch.keys || !has_lenses(level, state, door.touch.lenses))
        return show(state, door.touch.keys_message);
    state.progress.keys &= ~door.touch.keys;
    activations.activate(mover_ref(i));
}

void activate_secret_door(GameState& state, std::uint32_t i, Activations& activations) {
    if (state.movers[i].phase != Phase::AtStart) return;
    state.movers[i].has_been_fired = true;
    set_off(state, i, Phase::Leaving);
    activations.fire(mover_ref(i));
}

void touch_secret_door(const GameLevel& level, GameState& state, std::uint32_t i, Activations& activations) {
    MoverState& door = state.movers[i];
    if (state.tick < door.next_touch) return;
    door.next_touch = state.tick + kMessageRest_ticks;
    if (!door.has_been_fired) show(state, level.movers[i].touch.message);
    if (level.movers[i].touch.opens) activations.activate(mover_ref(i));
}

void press_button(GameState& state, std::uint32_t i) {
    if (!is_out(state.movers[i])) set_off(state, i, Phase::Leaving);
}

// A lift that waits above for activation goes down; from then on it is a normal lift.
void activate_lift(GameState& state, std::uint32_t i) {
    const MoverState& lift = state.movers[i];
    if (lift.phase == Phase::AtEnd && lift.wait_ticks < 0) set_off(state, i, Phase::Returning);
}

void touch_lift(GameState& state, std::uint32_t i) {
    MoverState& lift = state.movers[i];
    if (lift.phase == Phase::AtStart) set_off(state, i, Phase::Leaving);
    if (lift.phase == Phase::AtEnd && lift.wait_ticks >= 0) lift.wait_ticks = kRiderWait_ticks;
}

// Also one that stands at a corner for ever: in Quake it never leaves.
void activate_train(const Mover& mover, GameState& state, std::uint32_t i) {
    MoverState& train = state.movers[i];
    const bool waits =
        train.phase == Phase::AtEnd && train.wait_ticks == kForever && mover.legs[train.leg].next < mover.legs.size();
    if (waits) begin_next_leg(mover, train);
    if (waits || train.phase == Phase::AtStart) set_off(state, i, Phase::Leaving);
}

void touch_mover(const GameLevel& level, GameState& state, std::uint32_t i, Activations& activations) {
    const Mover& mover = level.movers[i];
    if (mover.kind == MoverKind::Button) return activations.activate(mover_ref(i));
    if (mover.kind == MoverKind::Lift) return touch_lift(state, i);
    if (mover.kind == MoverKind::SecretDoor) return touch_secret_door(level, state, i, activations);
    if (mover.touch.opens && !mover.touch.is_locked()) return touch_open_door(level, state, i, activations);
    touch_shut_door(level, state, i, activations);
}

}  // namespace

// Movers beyond the bound of a tick are stepped in the next tick.
void step_movers(const GameLevel& level, GameState& state, Activations& activations) {
    std::vector<std::uint32_t>& active = state.active_movers;
    if (!is_in_order(active)) active = movers_in_motion(state);
    TickReport& report = activations.report();
    std::rotate(active.begin(), std::lower_bound(active.begin(), active.end(), state.backlog.next_mover), active.end());
    std::vector<std::uint32_t> firing;
    auto next = active.begin();
    for (; next != active.end() && report.mover_steps < TickReport::kMostMoverSteps; ++next)
        if (step_mover(level, state, *next, report)) firing.push_back(*next);
    report.has_left_movers = next != active.end();
    state.backlog.next_mover = report.has_left_movers ? *next : 0;
    std::erase_if(active, [&](std::uint32_t i) { return is_at_rest(state.movers[i]); });
    for (const std::uint32_t i : firing) activations.fire(mover_ref(i));
}

void end_tick_of_movers(GameState& state) {
    const auto is_resting = [&](std::uint32_t i) { return is_at_rest(state.movers[i]); };
    std::vector<std::uint32_t>& active = state.active_movers;
    if (!is_in_order(active) || std::any_of(active.begin(), active.end(), is_resting)) active = movers_in_motion(state);
}

void touch_movers(const GameLevel& level, GameState& state, Activations& activations) {
    const Box player = player_box(state.player.position);
    for (const std::uint32_t i : activations.touched(level.boxes.touch, player, state.backlog.next_touch_box)) {
        const Mover& mover = level.movers[i];
        if (mover.touch.box && mover.touch.box->overlaps(player) && !is_removed(state.movers[i]))
            touch_mover(level, state, i, activations);
    }
}

void activate_mover(const GameLevel& level, GameState& state, std::uint32_t i, Activations& activations) {
    if (is_removed(state.movers[i])) return;
    switch (level.movers[i].kind) {
        case MoverKind::Door:
            return activate_door(level, state, i, activations);
        case MoverKind::SecretDoor:
            return activate_secret_door(state, i, activations);
        case MoverKind::Button:
            return press_button(state, i);
        case MoverKind::Lift:
            return activate_lift(state, i);
        case MoverKind::Train:
            return activate_train(level.movers[i], state, i);
    }
}

}  // namespace oblong

#include "game/movers.h"

#include <algorithm>

#include "game/collision.h"

namespace oblong {
namespace {

using Phase = MoverState::Phase;

bool is_moving(const MoverState& state) {
    return state.phase == Phase::Leaving || state.phase == Phase::Returning;
}

// A tick of the way, and the end where it is reached.
void travel(const Mover& mover, MoverState& state) {
    const bool is_leaving = state.phase == Phase::Leaving;
    const World step = is_leaving ? mover.speed_per_tick : -mover.speed_per_tick;
    state.travelled = std::clamp(state.travelled + step, World{}, mover.length);
    if (is_leaving && state.travelled == mover.length) {
        state.phase = Phase::AtEnd;
        state.wait_ticks = mover.wait_ticks;
    }
    if (!is_leaving && state.travelled == World{}) state.phase = Phase::AtStart;
}

void wait(const Mover& mover, MoverState& state) {
    if (mover.wait_ticks == Mover::kForever) return;
    if (state.wait_ticks > 0)
        --state.wait_ticks;
    else
        state.phase = Phase::Returning;
}

// The player goes where the mover takes or pushes; false where there is no room.
bool make_way(const Stage& stage, GameState& state, const Mover& mover, const Place& moved) {
    const bool rides = state.player.ground == mover.model.number();
    if (!rides && is_free(stage, state, state.player.place)) return true;
    if (is_free(stage, state, state.player.place + moved)) {
        state.player.place = state.player.place + moved;
        return true;
    }
    return is_free(stage, state, state.player.place);
}

void turn_round(MoverState& state) {
    state.phase = state.phase == Phase::Leaving || state.phase == Phase::AtEnd ? Phase::Returning : Phase::Leaving;
}

void move(const Stage& stage, GameState& state, std::size_t index) {
    const Mover& mover = stage.movers[index];
    const MoverState before = state.movers[index];
    const bool was_free = is_free(stage, state, state.player.place);
    travel(mover, state.movers[index]);
    const Place moved = offset_of(mover, state.movers[index]) - offset_of(mover, before);
    if (make_way(stage, state, mover, moved) || !was_free) return;
    state.movers[index] = before;
    turn_round(state.movers[index]);
}

void set_off_one(const Mover& mover, MoverState& state) {
    if (state.phase == Phase::AtEnd)
        state.wait_ticks = mover.wait_ticks;
    else
        state.phase = Phase::Leaving;
}

}  // namespace

void set_off(const Stage& stage, GameState& state, std::int32_t mover) {
    const auto index = static_cast<std::size_t>(mover);
    const bool is_new = !is_moving(state.movers[index]);
    set_off_one(stage.movers[index], state.movers[index]);
    if (!is_new) return;
    for (const std::int32_t other : stage.movers[index].starts) {
        const auto next = static_cast<std::size_t>(other);
        set_off_one(stage.movers[next], state.movers[next]);
    }
}

void touch_movers(const Stage& stage, GameState& state) {
    const Box player = player_box(state.player.place);
    for (std::size_t i = 0; i < stage.movers.size(); ++i)
        if (stage.movers[i].touch && stage.movers[i].touch->overlaps(player))
            set_off(stage, state, static_cast<std::int32_t>(i));
}

void step_movers(const Stage& stage, GameState& state) {
    for (std::size_t i = 0; i < stage.movers.size(); ++i) {
        if (is_moving(state.movers[i]))
            move(stage, state, i);
        else if (state.movers[i].phase == Phase::AtEnd)
            wait(stage.movers[i], state.movers[i]);
    }
}

}  // namespace oblong

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "game/simulation/collision.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

using Phase = MoverState::Phase;

constexpr std::int32_t kTeleporterTicks = kTicksPerSecond / 5;

bool is_moving(const MoverState& state) {
    return state.phase == Phase::Leaving || state.phase == Phase::Returning;
}

// Travels for a tick; changes the phase where an end is reached.
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

void reverse(MoverState& state) {
    state.phase = state.phase == Phase::Leaving || state.phase == Phase::AtEnd ? Phase::Returning : Phase::Leaving;
}

void move(const GameLevel& level, GameState& state, std::size_t index) {
    const Mover& mover = level.movers[index];
    MoverState after = state.movers[index];
    travel(mover, after);
    const Vec3<World> offset = offset_of(mover, after), moved = offset - offset_of(mover, state.movers[index]);
    const bool meets_player = state.player.ground == mover.model.number() ||
                              may_touch(level, mover.model, offset, player_box(state.player.position));
    const bool was_free = meets_player && is_free(level, state, state.player.position);
    const MoverState before = std::exchange(state.movers[index], after);
    if (!was_free || push_player(level, state, mover, moved)) return;
    state.movers[index] = before;
    reverse(state.movers[index]);
}

bool is_at_rest(const Mover& mover, const MoverState& state) {
    return state.phase == Phase::AtStart || (state.phase == Phase::AtEnd && mover.wait_ticks == Mover::kForever);
}

void activate_one(const GameLevel& level, GameState& state, std::uint32_t index) {
    const Mover& mover = level.movers[index];
    MoverState& mover_state = state.movers[index];
    if (mover_state.phase == Phase::AtEnd)
        mover_state.wait_ticks = mover.wait_ticks;
    else
        mover_state.phase = Phase::Leaving;
    if (is_at_rest(mover, mover_state)) return;
    const auto place = std::lower_bound(state.active_movers.begin(), state.active_movers.end(), index);
    if (place == state.active_movers.end() || *place != index) state.active_movers.insert(place, index);
}

}  // namespace

void switch_lights(const Target& target, GameState& state) {
    state.dark_styles ^= target.light_styles;
}

void activate_teleporters(const Target& target, GameState& state) {
    for (const std::uint32_t teleporter : target.teleporters)
        state.teleporter_ends[teleporter] = state.tick + kTeleporterTicks;
}

// Each target once, however many movers name it.
void activate(const GameLevel& level, GameState& state, std::span<const std::uint32_t> movers) {
    std::set<TargetIndex> targets, switched;
    for (const std::uint32_t i : movers) {
        const TargetIndex target = level.movers[i].target;
        if (target != kNoTarget && !is_moving(state.movers[i])) targets.insert(target);
        if (target != kNoTarget && state.movers[i].phase == Phase::AtStart) switched.insert(target);
        activate_one(level, state, i);
    }
    for (const TargetIndex index : switched) switch_lights(level.target(index), state);
    for (const TargetIndex index : targets) {
        const Target& target = level.target(index);
        for (const std::uint32_t i : target.movers) activate_one(level, state, i);
        activate_teleporters(target, state);
    }
}

void touch_movers(const GameLevel& level, GameState& state) {
    const Box player = player_box(state.player.position);
    std::vector<std::uint32_t> touched = level.touch_boxes.overlapping(player);
    std::erase_if(touched, [&](std::uint32_t i) {
        return !level.movers[i].touch_box || !level.movers[i].touch_box->overlaps(player);
    });
    activate(level, state, touched);
}

void step_movers(const GameLevel& level, GameState& state) {
    for (const std::uint32_t i : state.active_movers) {
        if (is_moving(state.movers[i]))
            move(level, state, i);
        else if (state.movers[i].phase == Phase::AtEnd)
            wait(level.movers[i], state.movers[i]);
    }
    std::erase_if(state.active_movers, [&](std::uint32_t i) { return is_at_rest(level.movers[i], state.movers[i]); });
}

}  // namespace oblong

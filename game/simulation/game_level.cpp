#include "game/simulation/game_level.h"

#include <algorithm>

#include "engine/base/text.h"
#include "engine/fixed/trig.h"
#include "game/simulation/level_builder.h"
#include "game/simulation/tick.h"

namespace oblong {
namespace {

constexpr std::int32_t kTrainDelay_ticks =
    kTicksPerSecond / 5;  // 0.2 s: Quake's trains find their first corner before they start

bool asks_here(const Trigger& trigger, const GameState& state) {
    return trigger.view && trigger.box && trigger.box->overlaps(player_box(state.player.position));
}

}  // namespace

GameLevel make_game_level(const Level& bsp) {
    return LevelBuilder(bsp).build();
}

GameState start_of(const GameLevel& level) {
    GameState state;
    state.player.position = level.start.position;
    state.player.yaw = level.start.yaw;
    state.progress.respawn = level.start;
    state.movers.resize(level.movers.size());
    for (std::size_t i = 0; i < level.movers.size(); ++i) {
        const Mover& mover = level.movers[i];
        if (mover.starts_at_end) {
            state.movers[i].phase = MoverState::Phase::AtEnd;
            state.movers[i].travelled = mover.legs.front().length;
            state.movers[i].wait_ticks = kForever;
        }
        if (mover.starts_by_itself) {
            state.movers[i].phase = MoverState::Phase::Leaving;
            state.movers[i].wait_ticks = kTrainDelay_ticks;
        }
    }
    state.active_movers = movers_in_motion(state);
    state.walls.resize(level.walls.size());
    state.triggers.resize(level.triggers.size());
    for (std::size_t i = 0; i < level.triggers.size(); ++i)
        if (!level.triggers[i].starts_off) state.triggers[i].left = level.triggers[i].count;
    for (const std::uint32_t i : level.timers) state.triggers[i].ready_tick = level.triggers[i].wait_ticks;
    state.items.resize(level.items.size());
    state.dark_styles = level.dark_styles;
    return state;
}

std::vector<std::uint32_t> movers_in_motion(const GameState& state) {
    std::vector<std::uint32_t> moving;
    for (std::uint32_t i = 0; i < state.movers.size(); ++i)
        if (!is_at_rest(state.movers[i])) moving.push_back(i);
    return moving;
}

std::optional<ViewDialKind> asked_dial(const GameLevel& level, const GameState& state) {
    for (const Trigger& trigger : level.triggers) {
        if (!asks_here(trigger, state)) continue;
        for (std::size_t i = 0; i < kViewDials; ++i)
            if (trigger.view->dials[i]) return static_cast<ViewDialKind>(i);
    }
    return std::nullopt;
}

bool asks_for_work(const GameLevel& level, const GameState& state) {
    return std::any_of(level.triggers.begin(), level.triggers.end(), [&](const Trigger& trigger) {
        return asks_here(trigger, state) && trigger.view->asks_for_work();
    });
}

std::string pulled_machine(const GameLevel& level, const GameState& before, const GameState& after) {
    using enum MoverState::Phase;
    std::string machine;
    for (const std::uint32_t i : before.active_movers)
        if (before.movers[i].phase != AtEnd && after.movers[i].phase == AtEnd && machine.empty())
            machine = item(level.bsp->entities, level.movers[i].entity).value("machine");
    return machine;
}

std::string_view next_map(const GameLevel& level, const GameState& state) {
    if (state.exit < 0) return {};
    return item(level.triggers, state.exit).next_map;
}

std::string_view end_message(const GameLevel& level, const GameState& state) {
    const MessageIndex message = state.is_lost()  ? level.died
                                 : state.exit < 0 ? kNoMessage
                                                  : item(level.triggers, state.exit).fires.message;
    return message == kNoMessage ? std::string_view{} : item(level.messages, message);
}

std::string missed_secrets(const GameLevel& level, const GameState& state) {
    std::string missed;
    for (std::size_t i = 0; i < level.triggers.size(); ++i) {
        if (!level.triggers[i].is_secret || state.triggers[i].ready_tick == TriggerState::kNever) continue;
        const std::string name = level_text(level.bsp->entities[level.triggers[i].entity].value("netname"));
        if (!name.empty()) missed += (missed.empty() ? "" : ", ") + name;
    }
    return missed;
}

Box obstacle_box(const GameLevel& level, ModelIndex model, const Vec3<World>& offset) {
    return box_of(level.model(model).box).grown(world_vector(2, 2, 2)).moved(offset);
}

Angle turn_of(const Mover& mover, World travelled) {
    const Angle turned = degrees_to_angle(convert<Degrees>(travelled));
    return mover.turns == 0 ? Angle{} : mover.turns > 0 ? turned : -turned;
}

Vec3<World> offset_of(const Mover& mover, const MoverState& state) {
    const Leg& leg = mover.legs[state.leg];
    if (leg.length == World{}) return leg.from;
    return leg.from + scaled(leg.way, state.travelled, leg.length);
}

}  // namespace oblong

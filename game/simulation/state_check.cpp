#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "game/simulation/activations.h"
#include "game/simulation/collision.h"
#include "game/simulation/game_level.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

constexpr std::int64_t kLastTick = std::int64_t{1} << 40;  // a thousand years
constexpr World kFastestSaved = World::from_int(4096);     // along an axis; the player's own bound is half of that
constexpr std::int32_t kLongestWait_ticks = 3'000'000;     // above the largest values of two keys: of a timer

// Keeps the first error.
class Check {
  public:
    void expect(bool is_right, std::string what) {
        if (!is_right && wrong_.empty()) wrong_ = std::move(what);
    }
    void expect_length(const char* name, std::size_t length, std::size_t expected) {
        expect(length == expected,
               std::string(name) + ": " + std::to_string(length) + ", expected " + std::to_string(expected));
    }
    bool is_fine() const { return wrong_.empty(); }
    std::string result() && { return std::move(wrong_); }

  private:
    std::string wrong_;
};

bool is_tick(std::int64_t tick) {
    return tick >= 0 && tick <= kLastTick;
}

// Enumerations and bool read from outside may hold any number.
template <class Enumeration>
bool is_one_of(Enumeration value, Enumeration last) {
    return static_cast<std::uint8_t>(value) <= static_cast<std::uint8_t>(last);
}

void check_player(const GameLevel& level, const Player& player, Check& check) {
    check.expect(is_within(player.position, kFarthestPlayer), "player: a position outside the world");
    check.expect(is_within(player.velocity, kFastestSaved), "player: a velocity above any that the game makes");
    check.expect(player.pitch >= -Player::kSteepestPitch && player.pitch <= Player::kSteepestPitch,
                 "player: pitch " + std::to_string(player.pitch) + ", expected -16000 to 16000");
    check.expect(is_within(player.eye_lag, World::from_int(kStepHeight)), "player: an eye more than a step too low");
    check.expect(player.ground >= Player::kNoGround && player.ground < level.bsp->models.count(),
                 "player: stands on model " + std::to_string(player.ground) + ", which the level does not have");
    check.expect(is_one_of(player.depth, Depth::Eyes), "player: an unknown depth");
}

bool is_soon(std::int64_t tick, const GameState& state) {
    return tick >= 0 && tick <= state.tick + kLongestWait_ticks;
}

bool is_possible(const Mover& mover, const MoverState& state) {
    return is_one_of(state.phase, MoverState::Phase::Removed) && state.leg < mover.legs.size() &&
           state.travelled >= World{} && state.travelled <= mover.legs[state.leg].length &&
           state.wait_ticks >= kForever && state.wait_ticks <= kLongestWait_ticks;
}

// At 0 a counter fires and is gone.
bool is_possible(const Trigger& trigger, const TriggerState& trigger_state, const GameState& state) {
    const bool is_gone = trigger_state.ready_tick == TriggerState::kNever;
    const bool counts = trigger.kind == TriggerKind::Counter && !is_gone;
    return (is_gone || is_soon(trigger_state.ready_tick, state)) && is_soon(trigger_state.open_until, state) &&
           trigger_state.left >= (counts ? 1 : 0) && trigger_state.left <= trigger.count;
}

void check_movers(const GameLevel& level, const GameState& state, Check& check) {
    for (std::size_t i = 0; i < level.movers.size(); ++i)
        check.expect(is_possible(level.movers[i], state.movers[i]) && is_soon(state.movers[i].next_touch, state),
                     "movers: number " + std::to_string(i) + " is outside its path");
    check.expect(movers_in_motion(state) == state.active_movers, "active movers: not the movers in motion");
}

void check_triggers(const GameLevel& level, const GameState& state, Check& check) {
    std::int32_t secrets_gone = 0;
    for (std::size_t i = 0; i < level.triggers.size(); ++i) {
        check.expect(is_possible(level.triggers[i], state.triggers[i], state),
                     "triggers: number " + std::to_string(i) + " has a state that it can't have");
        secrets_gone += level.triggers[i].is_secret && state.triggers[i].ready_tick == TriggerState::kNever;
    }
    check.expect(state.progress.found_secrets >= 0 && state.progress.found_secrets <= secrets_gone,
                 std::to_string(state.progress.found_secrets) + " secrets found, expected no more than are gone");
}

void check_others(const GameLevel& level, const GameState& state, Check& check) {
    for (const WallState wall : state.walls)
        check.expect(is_one_of(wall, WallState::Removed), "walls: an unknown state");
    for (const ItemState item : state.items)
        check.expect(is_one_of(item, ItemState::Removed), "items: an unknown state");
    std::vector<std::uint32_t> taken;
    for (std::uint32_t i = 0; i < state.items.size(); ++i)
        if (state.items[i] == ItemState::Taken) taken.push_back(i);
    check.expect(
        std::is_permutation(taken.begin(), taken.end(), state.progress.taken.begin(), state.progress.taken.end()),
        "items: those in the order of taking are not those that are taken");
    check.expect(
        state.message.shown >= kNoMessage && state.message.shown < static_cast<std::int64_t>(level.messages.size()),
        "message " + std::to_string(state.message.shown) + ", which the level does not have");
    check.expect(state.exit >= -1 && state.exit < static_cast<std::int64_t>(level.triggers.size()),
                 "exit " + std::to_string(state.exit) + ", which the level does not have");
    check.expect(state.progress.keys >> level.key_names.size() == 0, "unknown keys");
    check.expect(state.harm.damage >= 0 && state.harm.damage <= level.health, "more damage than health");
    check.expect(is_within(state.progress.respawn.position, kFarthestPlayer), "a place to come in outside the world");
}

// Walls fire nothing.
bool is_there(const GameLevel& level, const EntityRef& entity) {
    const std::array counts{level.movers.size(), std::size_t{0}, level.triggers.size(), level.items.size()};
    return is_one_of(entity.kind, EntityRef::Kind::Item) && entity.index < item(counts, entity.kind);
}

void check_delayed(const GameLevel& level, const GameState& state, Check& check) {
    check.expect(state.delayed.size() <= Activations::kMost, "delayed: too many");
    std::int64_t earliest = state.tick;
    for (const DelayedFiring& delayed : state.delayed) {
        check.expect(is_there(level, delayed.by), "delayed: by something that the level does not have");
        const bool is_next = state.has_ended || (delayed.tick > state.tick && delayed.tick >= earliest);
        check.expect(is_next && is_tick(delayed.tick), "delayed: not the earliest first");
        earliest = delayed.tick;
    }
}

void check_backlog(const GameLevel& level, const GameState& state, Check& check) {
    const Backlog& backlog = state.backlog;
    check.expect(backlog.waiting.size() <= Activations::kMost, "waiting: too many");
    for (const WaitingFiring& waiting : backlog.waiting)
        check.expect(waiting.target >= 0 && as_size(waiting.target) < level.targets.size() &&
                         waiting.next < level.target(waiting.target).entities.size(),
                     "waiting: for something that the level does not have");
    check.expect(backlog.next_mover == 0 || backlog.next_mover < level.movers.size(), "the next mover: unknown");
    const auto check_place = [&](std::uint32_t place, const BoxTree& boxes) {
        check.expect(place == 0 || place < boxes.size(), "the next box: unknown");
    };
    check_place(backlog.next_touch_box, level.boxes.touch);
    check_place(backlog.next_trigger_box, level.boxes.triggers);
    check_place(backlog.next_item_box, level.boxes.items);
}

}  // namespace

std::string find_inconsistency(const GameLevel& level, const GameState& state) {
    Check check;
    check.expect(is_tick(state.tick), "tick " + std::to_string(state.tick));
    check.expect(is_tick(state.message.tick) && state.message.tick <= state.tick, "a message of a tick to come");
    check.expect_length("movers", state.movers.size(), level.movers.size());
    check.expect_length("walls", state.walls.size(), level.walls.size());
    check.expect_length("triggers", state.triggers.size(), level.triggers.size());
    check.expect_length("items", state.items.size(), level.items.size());
    if (!check.is_fine()) return std::move(check).result();
    check_player(level, state.player, check);
    check_movers(level, state, check);
    check_triggers(level, state, check);
    check_others(level, state, check);
    check_delayed(level, state, check);
    check_backlog(level, state, check);
    return std::move(check).result();
}

}  // namespace oblong

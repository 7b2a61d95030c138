#include "game/simulation/activations.h"

#include <algorithm>

#include "game/simulation/step.h"

namespace oblong {
namespace {

using Kind = EntityRef::Kind;

const Firing& firing_of(const GameLevel& level, const EntityRef& entity) {
    if (entity.kind == Kind::Mover) return level.movers[entity.index].fires;
    if (entity.kind == Kind::Item) return level.items[entity.index].fires;
    return level.triggers[entity.index].fires;
}

void remove(GameState& state, const EntityRef& entity) {
    const std::uint32_t i = entity.index;
    if (entity.kind == Kind::Wall) state.walls[i] = WallState::Removed;
    if (entity.kind == Kind::Trigger) state.triggers[i].ready_tick = TriggerState::kNever;
    if (entity.kind == Kind::Item && state.items[i] == ItemState::There) state.items[i] = ItemState::Removed;
    if (entity.kind != Kind::Mover) return;
    state.movers[i].phase = MoverState::Phase::Removed;
    std::erase(state.active_movers, i);
}

void show_other_frames(WallState& wall) {
    if (wall == WallState::Removed) return;
    wall = wall == WallState::There ? WallState::ShowsOtherFrames : WallState::There;
}

}  // namespace

void show(GameState& state, MessageIndex message) {
    if (message == kNoMessage) return;
    state.shown_message = message;
    state.message_tick = state.tick;
}

void Activations::fire(const EntityRef& by) {
    const Firing& firing = firing_of(level_, by);
    if (firing.is_empty()) return;
    if (firing.delay_ticks == 0) return fire_now(firing);
    const DelayedFiring delayed{state_.tick + firing.delay_ticks, by};
    if (state_.delayed.size() >= kMost) return;
    state_.delayed.insert(
        std::upper_bound(state_.delayed.begin(), state_.delayed.end(), delayed,
                         [](const DelayedFiring& a, const DelayedFiring& b) { return a.tick < b.tick; }),
        delayed);
}

void Activations::activate(const EntityRef& entity) {
    add(entity);
    run();
}

void Activations::fire_delayed() {
    while (!state_.delayed.empty() && state_.delayed.front().tick <= state_.tick) {
        const EntityRef by = state_.delayed.front().by;
        state_.delayed.erase(state_.delayed.begin());
        fire_now(firing_of(level_, by));
    }
}

// As Quake's game code: what removes something activates nothing.
void Activations::fire_now(const Firing& firing) {
    show(state_, firing.message);
    if (firing.removed != kNoTarget) {
        for (const EntityRef& entity : level_.target(firing.removed).entities) remove(state_, entity);
        return;
    }
    if (firing.target == kNoTarget) return;
    const Target& target = level_.target(firing.target);
    state_.dark_styles ^= target.light_styles;
    for (auto entity = target.entities.rbegin(); entity != target.entities.rend(); ++entity) add(*entity);
    run();
}

void Activations::add(const EntityRef& entity) {
    if (activated_ == kMost) return;
    ++activated_;
    pending_.push_back(entity);
}

// Not from within itself: what an entity activates in turn waits on top of the others.
void Activations::run() {
    if (is_running_) return;
    is_running_ = true;
    while (!pending_.empty()) {
        const EntityRef entity = pending_.back();
        pending_.pop_back();
        activate_one(entity);
    }
    is_running_ = false;
}

void Activations::activate_one(const EntityRef& entity) {
    if (entity.kind == Kind::Mover) activate_mover(level_, state_, entity.index, *this);
    if (entity.kind == Kind::Trigger) activate_trigger(level_, state_, entity.index, *this);
    if (entity.kind == Kind::Wall) show_other_frames(state_.walls[entity.index]);
}

}  // namespace oblong

#include "game/simulation/activations.h"

#include <algorithm>
#include <utility>

#include "engine/base/table.h"
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
    if (entity.kind == Kind::Mover) state.movers[i].phase = MoverState::Phase::Removed;
}

bool is_earlier(const DelayedFiring& a, const DelayedFiring& b) {
    return a.tick < b.tick;
}

void show_other_frames(WallState& wall) {
    if (wall == WallState::Removed) return;
    wall = wall == WallState::There ? WallState::ShowsOtherFrames : WallState::There;
}

}  // namespace

void show(GameState& state, MessageIndex message) {
    if (message == kNoMessage) return;
    state.message.shown = message;
    state.message.tick = state.tick;
}

void Activations::fire(const EntityRef& by) {
    if (by.kind == Kind::Trigger) report_.fired_triggers.push_back(by.index);
    const Firing& firing = firing_of(level_, by);
    if (firing.is_empty()) return;
    if (firing.delay_ticks == 0) return fire_now(firing);
    count(1);
    if (state_.delayed.size() + delayed_.size() < kMost)
        delayed_.push_back({state_.tick + firing.delay_ticks, by});
    else
        report_.has_dropped_firings = true;
}

// The entity's own activations run after it.
void Activations::activate(const EntityRef& entity) {
    is_running_ = true;
    activate_one(entity);
    is_running_ = false;
    run();
}

// Each part has its own bound, so that an endless chain of one kind does not block the others.
void Activations::begin_tick() {
    left_ = TickReport::kMostWaitingActivations;
    pending_ = std::exchange(state_.backlog.waiting, {});
    run();
    left_ = TickReport::kMostDelayedActivations;
    fire_delayed();
    left_ = TickReport::kMostNewActivations;
}

void Activations::fire_delayed() {
    const auto end = std::find_if(state_.delayed.begin(), state_.delayed.end(),
                                  [&](const DelayedFiring& each) { return each.tick > state_.tick; });
    auto next = state_.delayed.begin();
    for (; next != end && left_ > 0; ++next) {
        count(1);
        fire_now(firing_of(level_, next->by));
    }
    for (auto late = next; late != end; ++late) late->tick = state_.tick + 1;
    report_.has_left_activations |= next != end;
    state_.delayed.erase(state_.delayed.begin(), next);
}

std::vector<std::uint32_t> Activations::touched(const BoxTree& boxes, const Box& player, std::uint32_t& from) {
    BoxTree::Part part = boxes.part_overlapping(player, from);
    from = part.next;
    report_.touches += static_cast<std::int32_t>(part.numbers.size());
    report_.has_left_touches |= from != 0;
    return std::move(part.numbers);
}

void Activations::end_tick() {
    state_.backlog.waiting.assign(late_.rbegin(), late_.rend());
    report_.has_left_activations |= !late_.empty();
    std::stable_sort(delayed_.begin(), delayed_.end(), is_earlier);
    const auto middle = static_cast<std::ptrdiff_t>(state_.delayed.size());
    state_.delayed.insert(state_.delayed.end(), delayed_.begin(), delayed_.end());
    std::inplace_merge(state_.delayed.begin(), state_.delayed.begin() + middle, state_.delayed.end(), is_earlier);
}

// As in Quake's game code, an entity that removes something activates nothing.
void Activations::fire_now(const Firing& firing) {
    show(state_, firing.message);
    const bool removes = firing.removed != kNoTarget;
    const TargetIndex index = removes ? firing.removed : firing.target;
    if (index == kNoTarget) return;
    const Target& target = level_.target(index);
    if (!removes) state_.dark_styles ^= target.light_styles;
    if (removes && target.entities.size() <= as_size(std::max(0, left_))) {
        count(target.entities.size());
        for (const EntityRef& entity : target.entities) remove(state_, entity);
        return;
    }
    if (!target.entities.empty()) push({index, 0, removes});
    run();
}

void Activations::push(const WaitingFiring& firing) {
    if (pending_.size() + late_.size() < kMost)
        pending_.push_back(firing);
    else
        report_.has_dropped_firings = true;
}

// Does not nest: what an entity activates in turn is pushed on top of the waiting ones.
void Activations::run() {
    if (is_running_) return;
    is_running_ = true;
    while (!pending_.empty() && left_ > 0) deliver_next();
    late_.insert(late_.end(), pending_.rbegin(), pending_.rend());
    pending_.clear();
    is_running_ = false;
}

void Activations::deliver_next() {
    WaitingFiring& firing = pending_.back();
    const std::vector<EntityRef>& entities = level_.target(firing.target).entities;
    const EntityRef entity = entities[firing.next++];
    const bool removes = firing.removes;
    if (firing.next == entities.size()) pending_.pop_back();
    if (!removes) return activate_one(entity);
    count(1);
    remove(state_, entity);
}

// A door activates its whole group.
void Activations::activate_one(const EntityRef& entity) {
    const bool is_mover = entity.kind == Kind::Mover;
    count(is_mover ? 1 + level_.movers[level_.movers[entity.index].group].group_members.size() : 1);
    if (is_mover) activate_mover(level_, state_, entity.index, *this);
    if (entity.kind == Kind::Trigger) activate_trigger(level_, state_, entity.index, *this);
    if (entity.kind == Kind::Wall) show_other_frames(state_.walls[entity.index]);
}

void Activations::count(std::size_t activations) {
    report_.activations += static_cast<std::int32_t>(activations);
    left_ -= static_cast<std::int32_t>(activations);
}

}  // namespace oblong

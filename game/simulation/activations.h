#pragma once

#include <cstdint>
#include <vector>

#include "game/simulation/game_level.h"
#include "game/simulation/state.h"
#include "game/simulation/tick.h"

namespace oblong {

/// What is activated in one tick. Entities activate others, which may activate each other in turn. Activations beyond a
/// tick's bounds (tick.h) wait for the next ticks, in order.
class Activations {
  public:
    /// The most activations that may wait, and the most firings with a delay; further ones are dropped.
    static constexpr std::size_t kMost = 16'384;

    Activations(const GameLevel& level, GameState& state) : level_(level), state_(state) {}
    Activations(const Activations&) = delete;
    Activations& operator=(const Activations&) = delete;

    /// Fires an entity, after its delay: shows its message; then removes its "killtarget", or else activates its
    /// targets, in their order.
    void fire(const EntityRef& by);

    /// Activates an entity, as an entity that targets it does.
    void activate(const EntityRef& entity);

    /// Called first in a tick: continues the waiting activations, and does the delayed firings that are due.
    void begin_tick();

    /// Called last in a tick: moves waiting and delayed firings into the state.
    void end_tick();

    /// The boxes that the player is in, or as many as a tick may look at; `from` becomes where the next tick continues.
    std::vector<std::uint32_t> touched(const BoxTree& boxes, const Box& player, std::uint32_t& from);

    TickReport& report() { return report_; }

  private:
    void fire_delayed();
    void fire_now(const Firing& firing);
    void push(const WaitingFiring& firing);
    void run();
    void deliver_next();
    void activate_one(const EntityRef& entity);
    void count(std::size_t activations);

    const GameLevel& level_;
    GameState& state_;
    TickReport report_;
    std::int32_t left_ = TickReport::kMostNewActivations;
    std::vector<WaitingFiring> pending_;  // the next one last
    std::vector<WaitingFiring> late_;     // for later ticks, the next one first
    std::vector<DelayedFiring> delayed_;  // new ones
    bool is_running_ = false;
};

/// Shows a message, unless it is kNoMessage.
void show(GameState& state, MessageIndex message);

}  // namespace oblong

#pragma once

#include <cstdint>
#include <vector>

#include "game/simulation/game_level.h"
#include "game/simulation/state.h"
#include "game/simulation/tick_report.h"

namespace oblong {

/// What is activated in one tick. Entities activate others, which activate others in turn, perhaps each other: what is
/// more than a tick may do (tick_report.h) waits for the next ones, in its order.
class Activations {
  public:
    /// The most that may wait; what comes on top is dropped. So for firings with a delay.
    static constexpr std::size_t kMost = 16'384;

    Activations(const GameLevel& level, GameState& state) : level_(level), state_(state) {}
    Activations(const Activations&) = delete;
    Activations& operator=(const Activations&) = delete;

    /// Does what an entity does to others, after its delay: shows its message; removes what it is to remove, or else
    /// activates its targets, in their order.
    void fire(const EntityRef& by);

    /// Activates an entity, as one whose target it is does.
    void activate(const EntityRef& entity);

    /// The first of a tick: goes on with what waits, and fires what was delayed until now.
    void begin_tick();

    /// The last of a tick: puts what is left, and what was delayed, into the state.
    void end_tick();

    /// The boxes that the player is in, or as many as a tick looks at; `from` becomes the place from which the next
    /// tick goes on.
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

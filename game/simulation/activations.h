#pragma once

#include <cstdint>
#include <vector>

#include "game/simulation/game_level.h"
#include "game/simulation/state.h"

namespace oblong {

/// What is activated in one tick. Entities activate others, which activate others in turn, perhaps each other: after
/// kMost activations the tick's further ones are dropped.
class Activations {
  public:
    static constexpr int kMost = 65'536;

    Activations(const GameLevel& level, GameState& state) : level_(level), state_(state) {}
    Activations(const Activations&) = delete;
    Activations& operator=(const Activations&) = delete;

    /// Does what an entity does to others, after its delay: shows its message; removes what it is to remove, or else
    /// activates its targets, in their order.
    void fire(const EntityRef& by);

    /// Activates an entity, as one whose target it is does.
    void activate(const EntityRef& entity);

    /// Fires what was delayed until now.
    void fire_delayed();

  private:
    void fire_now(const Firing& firing);
    void add(const EntityRef& entity);
    void run();
    void activate_one(const EntityRef& entity);

    const GameLevel& level_;
    GameState& state_;
    std::vector<EntityRef> pending_;  // the next one last
    int activated_ = 0;
    bool is_running_ = false;
};

/// Shows a message, unless it is kNoMessage.
void show(GameState& state, MessageIndex message);

}  // namespace oblong

#pragma once

#include <optional>
#include <string>

#include "engine/platform/controls.h"
#include "game/demo.h"
#include "game/live_input.h"
#include "game/stage.h"

namespace oblong {

/// Who plays: a recorded demo until it ends, then the one at the keys. Records what is played, if asked to.
class Hands {
  public:
    /// Throws InputError where the demo was not recorded on this stage.
    Hands(const GameState& start, std::optional<Demo> replayed, bool records);

    void gather(const Controls& controls) { live_.gather(controls); }

    /// Moves the state by a tick. Throws InputError where a replayed tick leads to another state than when it was
    /// recorded.
    void play_tick(const Stage& stage, GameState& state);

    ViewLead lead(std::int32_t fraction_16) const;
    bool is_replaying() const { return replayed_ && next_ < replayed_->ticks.size(); }
    const Demo& recorded() const { return recorded_; }

  private:
    LiveInput live_;
    std::optional<Demo> replayed_;
    std::size_t next_ = 0;  // tick of the replayed demo
    TickInput last_;
    bool records_, was_replayed_ = false;
    Demo recorded_;
};

}  // namespace oblong

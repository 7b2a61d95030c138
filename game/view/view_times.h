#pragma once

#include "engine/files/rendering_times.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// Times of warm renderings of one view with one setting; a new view or setting clears them.
class ViewTimes {
  public:
    explicit ViewTimes(FrameClock clock = steady_clock_ns) : times_(kMost, clock) {}

    /// Draws the renderer's last picture once more, and times it.
    void time(const GameView& view, const Settings& settings, GameRenderer& renderer);
    const RenderingTimes& renderings() const { return times_; }

  private:
    static constexpr std::size_t kMost = 31;

    RenderingTimes times_;
    ViewSpec view_;
    Settings settings_;
};

}  // namespace oblong

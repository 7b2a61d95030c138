#pragma once

#include <string>

#include "engine/effects/palette_effects.h"
#include "game/game_renderer.h"
#include "game/view_times.h"
#include "tools/common/drawing.h"
#include "tools/common/text.h"

namespace oblong {

/// What F6 shows.
struct CostText {
    ColourTable background{};               ///< what the picture becomes behind it
    std::string frame;                      ///< time and rate of frames; empty: nothing is shown
    std::vector<PlanLine> passes, effects;  ///< what makes up the frame; effects without those that are passes
};

/// How many rows draw_cost() draws over; 0 where there is nothing to show.
std::int32_t cost_height_px(const CostText& text, Framebuffer canvas);
/// Draws the text so that it ends above the row `bottom`: the plan's passes at the left, effects at the right.
void draw_cost(const CostText& text, std::int32_t bottom, TextColours colours, Framebuffer canvas);

/// Measures what the view that is shown costs, as long as it exists.
class FrameCost {
  public:
    FrameCost(const Palette& palette, std::uint64_t now_us);

    /// Times one more rendering of the view that `renderer` has just drawn. True each half second: the text is to be
    /// made anew.
    bool note(const GameView& view, const Settings& settings, GameRenderer& renderer, std::uint64_t now_us);
    /// Of the view noted last. Draws it once more, to the same picture, to count pixels.
    CostText measure(const GameView& view, const Settings& settings, const Palette& palette,
                     const PaletteEffects& effects, GameRenderer& renderer) const;

  private:
    ColourTable background_;
    ViewTimes times_;
    std::uint64_t since_us_, frames_ = 0, frames_a_second_ = 0;
};

}  // namespace oblong

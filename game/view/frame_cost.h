#pragma once

#include <string>

#include "engine/draw/drawing.h"
#include "engine/draw/text.h"
#include "engine/effects/palette_effects.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// The text that F6 shows.
struct CostText {
    ColourTable background{};               ///< darkens the picture behind the text
    std::string frame;                      ///< time and rate of frames; empty: nothing is shown
    std::vector<PlanLine> passes, effects;  ///< the parts of the frame; effects without those that are passes
};

/// How the text is split into pages.
struct CostTable {
    std::int32_t height_px = 0;  ///< of each page; 0: nothing to show
    std::size_t lines = 0;       ///< in a column of a page
    std::int32_t pages = 1;
};

/// Pages that fit into `room_px` rows; the frame's time is always shown.
CostTable lay_out_cost(const CostText& text, std::int32_t room_px, TextColours colours, Framebuffer canvas);
/// Draws a page, from 1, so that it ends above the row `bottom`: the plan's passes at the left, effects at the right;
/// in a canvas too narrow for both, effects follow the passes, without counts of pixels.
void draw_cost(const CostText& text, const CostTable& table, std::int32_t page, std::int32_t bottom,
               TextColours colours, Framebuffer canvas);

/// Measures the cost of the current view, as long as it exists.
class FrameCost {
  public:
    FrameCost(const Palette& palette, std::uint64_t now_us);

    /// Times one more rendering of the view that `renderer` has just drawn. Each half second it updates the text, for
    /// which it draws the same picture once more to count pixels.
    void note(const GameView& view, const Settings& settings, const Palette& palette, const PaletteEffects& effects,
              std::uint64_t now_us, GameRenderer& renderer);
    const CostText& text() const { return text_; }

  private:
    CostText text_;
    ViewTimes times_;
    std::uint64_t since_us_, frames_ = 0;
};

}  // namespace oblong

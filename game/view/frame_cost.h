#pragma once

#include <string>

#include "engine/draw/drawing.h"
#include "engine/draw/text.h"
#include "engine/effects/palette_effects.h"
#include "game/view/game_renderer.h"
#include "game/view/view_times.h"

namespace oblong {

/// What F6 shows.
struct CostText {
    ColourTable background{};               ///< what the picture becomes behind it
    std::string frame;                      ///< time and rate of frames; empty: nothing is shown
    std::vector<PlanLine> passes, effects;  ///< what makes up the frame; effects without those that are passes
};

/// How the text is cut into pages, in a canvas.
struct CostTable {
    std::int32_t height_px = 0;  ///< of each page; 0 where there is nothing to show
    std::size_t lines = 0;       ///< of a column of a page
    std::int32_t pages = 1;
};

/// The pages that fit into so many rows; at least the frame's time is shown, whatever the room.
CostTable lay_out_cost(const CostText& text, std::int32_t room_px, TextColours colours, Framebuffer canvas);
/// Draws a page, of 1 and on, so that it ends above the row `bottom`: the plan's passes at the left, effects at the
/// right; in a canvas too narrow for both, below them and without pixels.
void draw_cost(const CostText& text, const CostTable& table, std::int32_t page, std::int32_t bottom,
               TextColours colours, Framebuffer canvas);

/// Measures what the view that is shown costs, as long as it exists.
class FrameCost {
  public:
    FrameCost(const Palette& palette, std::uint64_t now_us);

    /// Times one more rendering of the view that `renderer` has just drawn. Each half second the text is made anew:
    /// then draws the view once more, to the same picture, to count pixels.
    void note(const GameView& view, const Settings& settings, const Palette& palette, const PaletteEffects& effects,
              std::uint64_t now_us, GameRenderer& renderer);
    const CostText& text() const { return text_; }

  private:
    CostText text_;
    ViewTimes times_;
    std::uint64_t since_us_, frames_ = 0;
};

}  // namespace oblong

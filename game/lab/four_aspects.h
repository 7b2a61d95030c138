#pragma once

#include <array>
#include <memory>

#include "game/lab/aspect_guide.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// One of the four combinations of F2 and F3, and its place in the picture of all four.
struct AspectView {
    bool corrects_projection, corrects_display;
    Area cell;        ///< a quarter of the canvas
    Area area;        ///< of the picture in it
    ScreenMode mode;  ///< of that size, with the same view as the whole picture
};

/// The four, each in its own shape in a window whose pixels have shape `pixel` (width to height). Corrected projection
/// at the left, corrected display at the top.
std::array<AspectView, 4> four_aspects(const ScreenMode& mode, Ratio pixel);

/// "drawn 4:3, shown square:\n17 % too flat".
std::string caption_of(const AspectView& view, const ScreenMode& mode);

/// Draws the four combinations of F2 and F3 in one picture.
class FourAspects {
  public:
    /// `data` and `level` outlive it.
    FourAspects(const GameData& data, const GameLevel& level) : data_(data), level_(level) {}

    void draw(const GameView& view, const Settings& settings, const ScreenMode& mode, Ratio pixel, TextColours colours,
              Framebuffer canvas);

  private:
    void draw_view(const GameView& view, const Settings& settings, const AspectView& aspect,
                   std::unique_ptr<GameRenderer>& renderer, Framebuffer out);

    const GameData& data_;
    const GameLevel& level_;
    std::array<std::unique_ptr<GameRenderer>, 4> renderers_;  ///< remade when a mode changes
};

}  // namespace oblong

#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "engine/draw/drawing.h"
#include "engine/view/present_rect.h"
#include "engine/view/screen.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// Width to height of a pixel in the window; 1:1 if nothing is shown.
Ratio shown_pixel(const PresentRect& shown, const ScreenMode& mode);

/// Width to height of a sphere in the middle of the picture, with pixels of shape `pixel`: 1:1 is round.
/// `corrects_projection`: Settings::correct_aspect.
Ratio sphere_shape(const ScreenMode& mode, bool corrects_projection, Ratio pixel);

/// "round", or by how much a side is too short: "17 % too flat" for 6:5, "17 % too narrow" for 5:6.
std::string describe_shape(Ratio width_to_height);

/// The shape of the display that the mode is for: "4:3".
std::string display_name(const ScreenMode& mode);
/// What follows "shown": "on 4:3", "with square pixels", "in the window's shape".
std::string shown_name(ShownAs shown_as, const ScreenMode& mode);

/// "Drawn for 4:3, shown with square pixels:\nspheres 17 % too flat, the circle 17 % too flat".
std::string aspect_caption(const ScreenMode& mode, bool corrects_projection, ShownAs shown_as, Scaling scaling,
                           WindowSize window);

struct Pixel {
    std::int32_t x, y;
};
/// A circle in the middle of the picture, round on the mode's display: the inside pixels with a neighbour outside.
std::vector<Pixel> circle_outline(const ScreenMode& mode);
/// A square around the circle, square on the mode's display.
Area true_square(const ScreenMode& mode);

void draw_aspect_guide(const ScreenMode& mode, TextColours colours, Framebuffer canvas);

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

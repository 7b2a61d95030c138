#pragma once

#include <string>
#include <vector>

#include "engine/draw/drawing.h"
#include "engine/draw/text.h"
#include "engine/view/present_rect.h"
#include "engine/view/screen.h"

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

}  // namespace oblong

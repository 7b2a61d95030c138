#pragma once

#include "engine/draw/drawing.h"
#include "engine/surface/palette.h"
#include "engine/view/screen.h"
#include "game/options/preferences.h"

namespace oblong {

/// Where a picture shows the view, and the mode in which it is drawn.
struct PlacedView {
    Area area;        ///< of the picture
    ScreenMode mode;  ///< its pixels have the shape of the picture's, or are twice as wide
};
PlacedView place_view(const ScreenMode& picture, const ViewSize& size);

/// The size of a picture's view; the whole picture if it cannot be drawn in that size.
ViewSize drawable_size(const PicturePreferences& picture);

/// Shows each column of `drawn` twice. `shown` is as high and twice as wide.
void double_columns(Framebuffer drawn, Framebuffer shown);

/// The colours of what is around a view: a board with a bevelled edge.
struct BorderColours {
    explicit BorderColours(const Palette& palette);
    std::uint8_t board, lit, dark;
};
/// Fills the picture around the view.
void draw_around(const Area& view, const BorderColours& colours, Framebuffer picture);

}  // namespace oblong

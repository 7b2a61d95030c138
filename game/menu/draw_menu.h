#pragma once

#include "game/menu/menu_layout.h"

namespace oblong {

/// Draws a page over a canvas whose picture becomes dark behind it.
void draw_menu(const MenuPage& page, const MenuView& view, const MenuLook& look, const Palette& palette,
               Framebuffer canvas);

}  // namespace oblong

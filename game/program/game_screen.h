#pragma once

#include <cstdint>

#include "engine/platform/controls.h"
#include "engine/surface/palette.h"
#include "engine/view/present_rect.h"
#include "engine/view/screen.h"
#include "game/menu/menu_look.h"

namespace oblong {

/// A picture and how the window shows it.
struct ShownPicture {
    Framebuffer canvas;
    Palette palette;
    PresentRect rect;
};

/// What fills the window, behind the menu or alone: a game or the gallery.
class GameScreen {
  public:
    GameScreen() = default;
    GameScreen(const GameScreen&) = delete;
    GameScreen& operator=(const GameScreen&) = delete;
    virtual ~GameScreen() = default;

    /// Takes the player's input and moves on to `now_us`, a platform's time.
    virtual void advance(const Controls& controls, std::uint64_t now_us) = 0;
    /// The same without either: nothing moves until advance() is called again.
    virtual void pause(std::uint64_t now_us) = 0;
    /// Draws what is up now; behind a menu without text, maps and panels, which would mix with it. The canvas is valid,
    /// and may be drawn over, until the next call.
    virtual ShownPicture draw(bool is_behind_menu) = 0;
    /// The colours of a menu over it.
    virtual const MenuLook& menu_look() const = 0;
};

}  // namespace oblong

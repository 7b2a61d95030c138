#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/surface/palette.h"
#include "engine/view/present_rect.h"
#include "engine/view/screen.h"
#include "game/input/bindings.h"
#include "game/input/controls.h"
#include "game/level/load.h"
#include "game/menu/menu_look.h"
#include "game/menu/menu_pages.h"

namespace oblong {

/// A picture and how the window shows it.
struct ShownPicture {
    Framebuffer canvas;
    Palette palette;
    PresentRect rect;
};

/// A screen that fills the window, alone or behind the menu: the title, a walk or the gallery.
class GameScreen {
  public:
    GameScreen() = default;
    GameScreen(const GameScreen&) = delete;
    GameScreen& operator=(const GameScreen&) = delete;
    virtual ~GameScreen() = default;

    /// Takes the player's input and moves on to `now_us`, a platform's time.
    virtual void advance(const Controls& controls, std::uint64_t now_us) = 0;
    /// The same while a menu takes the input: most screens are paused.
    virtual void advance_behind_menu(std::uint64_t now_us) = 0;
    virtual bool moves_behind_menu() const { return false; }
    virtual bool is_heard(bool is_behind_menu) const = 0;
    /// Whether the mouse turns the view while no menu is open.
    virtual bool captures_mouse() const { return false; }
    /// Draws the screen; behind a menu without text, maps and panels, which would mix with it. The canvas is valid, and
    /// may be drawn over, until the next call.
    virtual ShownPicture draw(bool is_behind_menu) = 0;
    /// The platform's time up to which the last picture stays.
    virtual std::uint64_t shows_until_us() const { return 0; }
    /// That picture in the colours of now, if they have changed: a palette turns without drawing.
    virtual std::optional<ShownPicture> recoloured() { return std::nullopt; }
    /// The colours of a menu over this screen.
    virtual const MenuLook& menu_look() const = 0;

    /// Opens the page of the menu for a command, if there is one.
    virtual void open_page(Action command, MenuPages& pages) = 0;
    /// Opens a page that is due without a command, if there is one.
    virtual void open_due_page(MenuPages&) {}

    virtual const std::shared_ptr<const LoadedLevel>& shared_level() const = 0;
    virtual std::vector<KeyHelp> key_help(const KeyNames& names) const = 0;
    virtual std::string figures() const { return ""; }  ///< all figures of the current row
};

}  // namespace oblong

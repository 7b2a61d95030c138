#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/surface/palette.h"
#include "engine/view/present_rect.h"
#include "engine/view/screen.h"
#include "game/input/controls.h"
#include "game/input/key_names.h"
#include "game/level/loaded_level.h"
#include "game/menu/menu_look.h"
#include "game/menu/menu_pages.h"

namespace oblong {

/// A picture and how the window shows it.
struct ShownPicture {
    Framebuffer canvas;
    Palette palette;
    PresentRect rect;
};

/// What fills the window, behind the menu or alone: the title, a walk or the gallery.
class GameScreen {
  public:
    GameScreen() = default;
    GameScreen(const GameScreen&) = delete;
    GameScreen& operator=(const GameScreen&) = delete;
    virtual ~GameScreen() = default;

    /// Takes the player's input and moves on to `now_us`, a platform's time.
    virtual void advance(const Controls& controls, std::uint64_t now_us) = 0;
    /// The same while a menu takes the input: most screens stand still.
    virtual void advance_behind_menu(std::uint64_t now_us) = 0;
    virtual bool moves_behind_menu() const { return false; }
    virtual bool is_heard(bool is_behind_menu) const = 0;
    /// Whether the mouse turns the view while no menu is open.
    virtual bool captures_mouse() const { return false; }
    /// Draws what is up now; behind a menu without text, maps and panels, which would mix with it. The canvas is valid,
    /// and may be drawn over, until the next call.
    virtual ShownPicture draw(bool is_behind_menu) = 0;
    /// The colours of a menu over it.
    virtual const MenuLook& menu_look() const = 0;

    /// Opens the page of the menu that a command asks for, if it asks for one.
    virtual void open_page(Action command, MenuPages& pages) = 0;
    /// Opens the page that is due although nobody asked for it, if there is one.
    virtual void open_due_page(MenuPages&) {}

    virtual const std::shared_ptr<const LoadedLevel>& shared_level() const = 0;
    virtual std::vector<KeyHelp> key_help(const KeyNames& names) const = 0;
    virtual std::string figures() const { return ""; }  ///< all there are of what is up
};

}  // namespace oblong

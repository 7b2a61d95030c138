#pragma once

#include <vector>

#include "engine/view/present_rect.h"
#include "game/input/controls.h"
#include "game/menu/menu_layout.h"

namespace oblong {

/// The player's action in a menu, for which the caller plays sounds and redraws.
enum class MenuEvent : std::uint8_t { None, Moved, Changed, Accepted, WentBack };

/// A stack of open pages; the last one is shown. No page: the menu is closed.
class Menu {
  public:
    void open(MenuPageMaker make_page);
    /// Closes the page that is shown, or so many from there on, without calling their `back`.
    void close(std::size_t pages = 1) { pages_.resize(pages_.size() - pages); }
    void close_all() { pages_.clear(); }
    bool is_open() const { return !pages_.empty(); }
    std::size_t depth() const { return pages_.size(); }

    /// Handles the player's input: menu actions, Action::Menu as Back, the pointer. `shown`: where the window shows the
    /// canvas.
    MenuEvent handle(const Controls& controls, CanvasSize canvas, std::int32_t text_scale, const PresentRect& shown);
    void draw(std::int32_t text_scale, const MenuLook& look, const Palette& palette, Framebuffer canvas) const;

    /// The page that is shown, and its chosen row. The menu is open.
    MenuPage page() const { return pages_.back().make(); }
    std::size_t chosen() const { return pages_.back().chosen; }

  private:
    struct OpenPage {
        MenuPageMaker make;
        std::size_t chosen = 0, first = 0;
    };

    MenuEvent take_press(const Controls& controls);
    MenuEvent act(MenuAction action, CanvasSize canvas, std::int32_t text_scale);
    MenuEvent move(const MenuPage& page, int steps, CanvasSize canvas, std::int32_t text_scale);
    MenuEvent change(const MenuPage& page, int steps);
    MenuEvent accept(const MenuPage& page);
    MenuEvent go_back(const MenuPage& page);
    MenuEvent point(const Pointer& pointer, CanvasSize canvas, std::int32_t text_scale, const PresentRect& shown);
    MenuLayout layout_of(const MenuPage& page, CanvasSize canvas, std::int32_t text_scale) const;

    std::vector<OpenPage> pages_;
};

}  // namespace oblong

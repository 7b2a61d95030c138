#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/surface/palette.h"
#include "game/input/controls.h"
#include "game/menu/menu_look.h"

namespace oblong {

/// A small picture beside the chosen row.
struct MenuPicture {
    std::int32_t width_px = 0, height_px = 0;
    std::shared_ptr<const std::vector<Rgb8>> pixels;  ///< rows top to bottom; pages are made often, and share them
};

/// A line of a menu that can be chosen.
struct MenuRow {
    std::string label = {};
    std::string value = {};                      ///< at the right; may be empty
    std::string help = {};                       ///< at the foot of the page while the row is chosen
    std::function<void()> accept = {};           ///< nothing: accepting is a step of `change`
    std::function<void(int steps)> change = {};  ///< right: 1, left: -1; nothing: the row has no value to change
    std::optional<MenuPicture> picture = {};
};

struct MenuPage {
    std::string title = {};
    std::string text = {};                  ///< may be empty, and longer than the page
    std::vector<MenuRow> rows = {};         ///< none: the page is a text
    std::size_t first_chosen = 0;           ///< the row that is chosen when the page opens
    std::string help = {};                  ///< shown if the chosen row has none
    bool is_title = false;                  ///< its title is the game's name in large letters
    std::function<void()> back = {};        ///< called instead of closing the page
    std::function<void(Input)> press = {};  ///< the page waits for any input and ignores all others but Esc
    std::optional<Action> closed_by = {};   ///< the command that opened the page closes it, too

    /// Adds a row with an action; its help begins with a capital.
    MenuRow& add(std::string label, std::string row_help, std::function<void()> accept);
};

/// Makes a page for the current state; called again after each input.
using MenuPageMaker = std::function<MenuPage()>;

/// The layout of a page on a canvas. All areas are in pixels of the canvas and inside it.
struct MenuLayout {
    /// A line of the page's text, or a row.
    struct Item {
        Area area;
        std::string text;  ///< empty for a row
        std::optional<std::size_t> row;
        std::int32_t value_y = 0;  ///< of a row's value: in its first or its second line
    };

    std::int32_t scale = 1;  ///< of letters
    LetterCell title_cell;
    Area title;               ///< without its shadow
    Area body;                ///< of all items that are shown
    std::vector<Item> items;  ///< those that are shown
    std::size_t first = 0;    ///< the first item that is shown, of all of the page
    bool has_more_above = false, has_more_below = false;
    std::optional<Area> picture;  ///< of the chosen row
    std::int32_t help_y = 0;
    std::vector<std::string> help;
};

/// The size of a canvas.
struct CanvasSize {
    std::int32_t width_px = 0, height_px = 0;
};

/// The part of a page that is shown.
struct MenuView {
    std::size_t chosen = 0;       ///< a row of the page
    std::size_t first = 0;        ///< the first item to show, if the chosen row, unless it is row 0, is then visible
    std::int32_t text_scale = 1;  ///< Preferences::text_scale
};

/// Lays a page out. Letters are as large as `text_scale` and the canvas allow, with room for a dozen columns at least.
MenuLayout lay_out(const MenuPage& page, const MenuView& view, CanvasSize canvas);

/// A line cut to a number of columns, with ".." for the rest.
std::string cut_to(const std::string& line, std::int32_t columns);

/// Draws a page over a canvas, and darkens the picture behind it.
void draw_menu(const MenuPage& page, const MenuView& view, const MenuLook& look, const Palette& palette,
               Framebuffer canvas);

}  // namespace oblong

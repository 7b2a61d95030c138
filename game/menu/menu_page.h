#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/surface/palette.h"
#include "game/input/controls.h"

namespace oblong {

/// A small picture beside the chosen row.
struct MenuPicture {
    std::int32_t width_px = 0, height_px = 0;
    std::vector<Rgb8> pixels;  ///< rows top to bottom
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
};

/// Makes a page for the current state; called again after each input.
using MenuPageMaker = std::function<MenuPage()>;

}  // namespace oblong

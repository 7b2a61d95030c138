#pragma once

#include <optional>

#include "game/menu/menu.h"
#include "game/menu/menu_host.h"

namespace oblong {

/// The bindings before the last change of them; nothing if there was none.
using KeyUndo = std::optional<Bindings>;

/// Opens the page that lists what each key does; each row opens one that changes it. All outlive the pages.
void open_key_pages(Menu& menu, MenuHost& host, KeyUndo& undo);

/// The inputs of an action as the player's keyboard names them: "W, Up"; "none".
std::string inputs_text(MenuHost& host, Action action);

}  // namespace oblong

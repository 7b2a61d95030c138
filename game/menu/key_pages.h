#pragma once

#include "game/menu/menu.h"
#include "game/menu/menu_host.h"

namespace oblong {

/// Opens the page that lists what each key does; each row opens one that changes it.
void open_key_pages(Menu& menu, MenuHost& host);

/// The inputs of an action as the player's keyboard names them: "W, Up"; "none".
std::string inputs_text(MenuHost& host, Action action);

}  // namespace oblong

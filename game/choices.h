#pragma once

#include <string>

#include "engine/frame/settings.h"
#include "engine/platform/controls.h"
#include "engine/platform/present_rect.h"
#include "engine/screen/screen.h"

namespace oblong {

/// What the keys change while one plays: how the world is drawn and how the picture is shown, never what happens in it.
struct Choices {
    Preset preset = Preset::Bounded;
    bool corrects_projection = true;
    ShownAs shown_as = ShownAs::OnDisplay;
    Scaling scaling = Scaling::SharpBilinear;
    bool shows_help = false, shows_cost = false;
};

Settings settings_of(const Choices& choices);

/// Does what a key asks for; the line that tells the user so ("" where there is nothing to tell). Screenshots are none
/// of its business.
std::string apply(Command command, Choices& choices, const ScreenMode& mode, WindowSize window);

}  // namespace oblong

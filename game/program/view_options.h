#pragma once

#include <string>

#include "engine/frame/frame.h"
#include "engine/platform/platform.h"
#include "engine/programs/frame_log.h"
#include "engine/view/present_rect.h"
#include "game/input/controls.h"
#include "game/lab/lab_options.h"
#include "game/options/preferences.h"
#include "game/program/view_choice.h"
#include "game/view/sign_colours.h"

namespace oblong {

/// Overlays and views that keys switch on over or instead of a game's picture; not saved.
struct Overlays {
    bool has_torch = false;
    bool is_isometric = false;      ///< the level from outside, instead of from the player's eye
    std::int32_t zoom_degrees = 0;  ///< the field of view of the dolly zoom; 0: off
    std::int32_t cost_page = 0;     ///< page of a frame's cost, from 1; 0: not shown
    bool shows_aspect_guide = false, shows_four_aspects = false;
    bool inspects = false;  ///< describes the object in the middle of the picture
    LogChannels log;        ///< written on standard error
    MapView map = MapView::Off;
    Wireframe wireframe = Wireframe::Off;
    LineMethod line_method = LineMethod::GuptaSproull;  ///< of map and wireframe
    LabOptions lab;
};

/// Options that keys change during a game: only how it is drawn and shown.
struct ViewOptions : Overlays {
    Preferences preferences;  ///< saved in the options file
    ViewChoice choice;
    bool uses_pad = false;  ///< the player's last input was a gamepad's: messages name its buttons

    KeyNames key_names(const Platform& platform) const { return {preferences.bindings, platform, uses_pad}; }
};

/// What a level can ask for of the options.
ViewDials view_dials_of(const ViewOptions& options);
/// Turns those dials that the player of a demo turned between two ticks.
void follow_view(const ViewDials& before, const ViewDials& after, ViewOptions& options);

/// Sets the preference `machine`; returns the message to the player for KeyNames::in(). No change and "" for a name
/// that is none of its values.
std::string choose_machine(const std::string& name, Preferences& preferences);

Settings settings_of(const Preferences& preferences);
WindowSettings window_settings_of(const WindowPreferences& preferences);
/// The picture that a window shows. In an upright window that of the usual mode is upright, too: 200x320 for a display
/// of 9:16, with the field of view from top to bottom.
PicturePreferences picture_in(WindowSize window, PicturePreferences preferences);
/// Where and how a window shows it.
PresentRect shown_rect(const PicturePreferences& preferences, WindowSize window);

/// Runs a command; returns a message to the player for KeyNames::in(), or "". Ignores commands of the program:
/// Action::Screenshot, Action::ShowHelp.
std::string apply(Action command, ViewOptions& options, WindowSize window);

}  // namespace oblong

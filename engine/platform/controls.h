#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/platform/input.h"

namespace oblong {

/// A command key, reported once for each press.
enum class Command {
    ShowHelp,          ///< F1
    ProjectionAspect,  ///< F2
    DisplayAspect,     ///< F3
    AccuracyTier,      ///< F4
    ScalingMode,       ///< F5
    FrameCost,         ///< F6
    LabPanel,          ///< F7
    ErrorMap,          ///< F8
    SplitView,         ///< F9
    FlipSettings,      ///< F10
    AspectGuide,       ///< F11
    Screenshot,        ///< F12
    FourAspects,       ///< 4
    Torch,             ///< L
    CrtLook,           ///< C
    Inspect,           ///< P
    Log,               ///< O
    Automap,           ///< Tab
    Wireframe,         ///< E
    Isometric,         ///< I
    ZoomIn,            ///< [: a narrower field of view from farther away
    ZoomOut,           ///< ]
    Darker,            ///< -
    Brighter,          ///< =
    DialUp,            ///< up arrow, again and again while it is held; for the lab, as are the other three
    DialDown,          ///< down arrow
    DialCoarser,       ///< left arrow
    DialFiner,         ///< right arrow
    PageUp,            ///< likewise while it is held; for the gallery
    PageDown,
    Menu,       ///< Esc, a gamepad's Start: opens the menu; in it, one page back
    QuickSave,  ///< Insert
    QuickLoad,  ///< Home
    Respawn,    ///< R: back to the place where the player came in last
    Restart,    ///< Backspace: the level again, from its start
};

/// What the player does in a menu. Each is reported when it is pressed, and again and again while it is held.
enum class MenuAction { Up, Down, Left, Right, Accept, Back };

/// The free mouse, in pixels of the window.
struct Pointer {
    std::int32_t x_px = 0, y_px = 0;
    bool has_moved = false, is_pressed = false;  ///< since the last poll
};

/// The arrow keys held now.
struct Arrows {
    bool up = false, down = false, left = false, right = false;
};

/// The player's input between two polls: keys held now, mouse motion and presses since the last poll.
struct Controls {
    bool forward = false, back = false, left = false, right = false;  ///< walk
    bool turn_left = false, turn_right = false, look_up = false, look_down = false;
    bool jump = false, walk_slowly = false;
    Arrows arrows;                          ///< not yet in the fields above: see walk_by_arrows()
    bool holds_button = false;              ///< any button of the captured mouse
    std::int32_t mouse_x = 0, mouse_y = 0;  ///< counts of the device, right and down positive
    std::vector<Command> commands;
    std::vector<MenuAction> menu;
    std::optional<Input> pressed;                 ///< the last of all inputs that were pressed, bound or not
    std::optional<Pointer> pointer;               ///< nothing while the mouse is captured, or where there is none
    bool has_focus = true, is_minimised = false;  ///< the window
};

/// Makes the arrow keys walk and turn.
inline void walk_by_arrows(Controls& controls) {
    controls.forward |= controls.arrows.up;
    controls.back |= controls.arrows.down;
    controls.turn_left |= controls.arrows.left;
    controls.turn_right |= controls.arrows.right;
}

}  // namespace oblong

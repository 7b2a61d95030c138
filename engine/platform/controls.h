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

/// What the player does in a menu. Each is reported when it is pressed, directions again and again while they are held.
enum class MenuAction { Up, Down, Left, Right, Accept, Back };

/// The free mouse, in pixels of the window.
struct Pointer {
    std::int32_t x_px = 0, y_px = 0;
    bool has_moved = false, is_pressed = false;  ///< since the last poll
};

/// A stick's place, -kFullAxis to kFullAxis: without a dead zone, as the device reports it.
struct Stick {
    std::int32_t x = 0, y = 0;  ///< right and up positive

    bool operator==(const Stick&) const = default;
};

/// What is held: moves that are on or off.
struct HeldMoves {
    bool forward = false, back = false, left = false, right = false;  ///< walk
    bool turn_left = false, turn_right = false, look_up = false, look_down = false;
    bool jump = false, walk_slowly = false;

    bool operator==(const HeldMoves&) const = default;
};

/// The player's input between two polls: what is held now or was pressed since the last poll, and mouse motion since.
struct Controls : HeldMoves {
    HeldMoves panel_keys;                   ///< not yet in the fields above: see walk_by_panel_keys()
    Stick walk_stick, look_stick;           ///< y: ahead, up
    bool holds_button = false;              ///< the first button of the captured mouse
    std::int32_t mouse_x = 0, mouse_y = 0;  ///< counts of the device, right and down positive
    std::vector<Command> commands;
    std::vector<MenuAction> menu;
    std::optional<Input> pressed;                 ///< the last of all inputs that were pressed, bound or not
    std::optional<Pointer> pointer;               ///< nothing while the mouse is captured, or where there is none
    bool has_focus = true, is_minimised = false;  ///< the window
    bool changes_full_screen = false;             ///< to the whole screen or back: Alt+Enter
};

/// Lets the keys that work an open panel (by default the arrow keys) move the player, as they do while none is open.
inline void walk_by_panel_keys(Controls& controls) {
    const HeldMoves& keys = controls.panel_keys;
    controls.forward |= keys.forward;
    controls.back |= keys.back;
    controls.left |= keys.left;
    controls.right |= keys.right;
    controls.turn_left |= keys.turn_left;
    controls.turn_right |= keys.turn_right;
    controls.look_up |= keys.look_up;
    controls.look_down |= keys.look_down;
    controls.jump |= keys.jump;
    controls.walk_slowly |= keys.walk_slowly;
}

}  // namespace oblong

#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "engine/base/table.h"
#include "engine/platform/input.h"

namespace oblong {

/// The actions that an input can be bound to, in the order of the table and of menus. Moves come first: a move is on
/// while one of its inputs is held. The others are commands: each press runs one once.
enum class Action : std::uint8_t {
    Forward,
    Left,  ///< sideways
    Back,
    Right,
    TurnLeft,
    TurnRight,
    LookUp,
    LookDown,
    Jump,
    WalkSlowly,
    Automap,
    Torch,
    Menu,  ///< opens the menu; in it, one page back
    QuickSave,
    QuickLoad,
    Respawn,  ///< back to Progress::respawn
    Restart,  ///< the level again, from its start
    ProjectionAspect,
    DisplayAspect,
    AccuracyTier,
    ScalingMode,
    FrameCost,
    LabPanel,
    ErrorMap,
    SplitView,
    FlipSettings,
    AspectGuide,
    Screenshot,
    FourAspects,
    Wireframe,
    Isometric,
    Inspect,
    ZoomIn,  ///< a narrower field of view, seen from farther away
    ZoomOut,
    CrtLook,
    Darker,
    Brighter,
    Log,
    ShowHelp,
    DialUp,  ///< this and the following operate a panel (lab, gallery), and repeat while held
    DialDown,
    DialCoarser,
    DialFiner,
    PageUp,
    PageDown
};
inline constexpr int kMoveCount = static_cast<int>(Action::WalkSlowly) + 1;
inline constexpr int kActionCount = static_cast<int>(Action::PageDown) + 1;

constexpr bool is_move(Action action) {
    return action <= Action::WalkSlowly;
}
constexpr bool is_of_panel(Action action) {
    return action >= Action::DialUp;
}

/// Names, texts and default inputs of an action. Inputs are as set_inputs() reads them.
struct ActionRow {
    Action action;
    std::string_view name;         ///< in the options file after "bind-", and in texts for KeyNames::in(): "turn-left"
    std::string_view label;        ///< in a menu, at most 20 characters: "Turn left"
    std::string_view help;         ///< on the page of keys, which joins rows with the same help; empty: not listed
    std::string_view keys;         ///< defaults, for both hands
    std::string_view others = "";  ///< of mouse and gamepad
    std::string_view left_hand = keys, right_hand = keys;
};

/// All actions, each at the place of its number.
std::span<const ActionRow> all_actions();
inline const ActionRow& row_of(Action action) {
    return all_actions()[as_size(action)];
}

/// The input with which a script presses an action, whatever the bindings.
constexpr Input scripted(Action action) {
    return {Device::Script, static_cast<std::uint16_t>(action)};
}

}  // namespace oblong

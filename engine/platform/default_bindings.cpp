#include "engine/base/table.h"
#include "engine/platform/bindings.h"

namespace oblong {
namespace {

// Inputs as set_inputs() reads them: the keys of each of the Hands, and what all three have.
struct DefaultInputs {
    Action action;
    std::array<std::string_view, kHandsCount> keys;
    std::string_view common = "";
};

constexpr DefaultInputs same(Command command, std::string_view keys, std::string_view common = "") {
    return {command, {keys, keys, keys}, common};
}

// The pad's cross is what the arrow keys are: it walks and turns, and works a panel that is open. The right button of
// the mouse walks ahead, so that a mouse alone gets through a level.
constexpr std::array<DefaultInputs, kActionCount> kDefaults{{
    {Move::Forward, {"W Up", "W", "Up Keypad-8"}, "Mouse-2 Pad-Up Pad-Left-Stick-Up"},
    {Move::Back, {"S Down", "S", "Down Keypad-2"}, "Pad-Down Pad-Left-Stick-Down"},
    {Move::Left, {"A", "A", "Delete Keypad-7"}, "Pad-Left-Stick-Left"},
    {Move::Right, {"D", "D", "End Keypad-9"}, "Pad-Left-Stick-Right"},
    {Move::TurnLeft, {"Left", "Q", "Left Keypad-4"}, "Pad-Left Pad-Right-Stick-Left"},
    {Move::TurnRight, {"Right", "E", "Right Keypad-6"}, "Pad-Right Pad-Right-Stick-Right"},
    {Move::LookUp, {"Page-Up", "R", "Page-Up Keypad-3"}, "Pad-Right-Stick-Up"},
    {Move::LookDown, {"Page-Down", "F", "Page-Down Keypad-1"}, "Pad-Right-Stick-Down"},
    {Move::Jump, {"Space", "Space", "Right-Ctrl Keypad-0"}, "Mouse-3 Pad-A Pad-Right-Trigger"},
    {Move::WalkSlowly, {"Left-Shift Right-Shift", "Left-Shift", "Right-Shift Keypad-5"}, "Pad-Left-Trigger"},
    same(Command::Menu, "", "Mouse-5"),
    {Command::Respawn, {"R", "T", "Keypad-Period"}, "Pad-Y"},
    same(Command::Restart, "Backspace"),
    same(Command::QuickSave, "Insert"),
    same(Command::QuickLoad, "Home"),
    {Command::Automap, {"Tab", "Tab", "Tab Keypad-Enter"}, "Pad-Back"},
    same(Command::ShowHelp, "F1"),
    same(Command::ProjectionAspect, "F2", "Pad-Left-Shoulder"),
    same(Command::DisplayAspect, "F3", "Pad-Right-Shoulder"),
    same(Command::AccuracyTier, "F4", "Pad-X"),
    same(Command::ScalingMode, "F5"),
    same(Command::FrameCost, "F6"),
    same(Command::LabPanel, "F7", "Pad-Left-Stick"),
    same(Command::ErrorMap, "F8"),
    same(Command::SplitView, "F9"),
    same(Command::FlipSettings, "F10"),
    same(Command::AspectGuide, "F11"),
    same(Command::Screenshot, "F12"),
    same(Command::FourAspects, "4"),
    same(Command::Torch, "L", "Pad-B"),
    same(Command::CrtLook, "C"),
    same(Command::Inspect, "P", "Pad-Right-Stick"),
    same(Command::Log, "O"),
    {Command::Wireframe, {"E", "X", "E"}},
    same(Command::Isometric, "I"),
    same(Command::ZoomIn, "Left-Bracket"),
    same(Command::ZoomOut, "Right-Bracket"),
    same(Command::Darker, "Minus"),
    same(Command::Brighter, "Equals"),
    {Command::DialUp, {"Up", "W Up", "Up Keypad-8"}, "Pad-Up"},
    {Command::DialDown, {"Down", "S Down", "Down Keypad-2"}, "Pad-Down"},
    {Command::DialCoarser, {"Left", "A Left", "Left Keypad-4"}, "Pad-Left"},
    {Command::DialFiner, {"Right", "D Right", "Right Keypad-6"}, "Pad-Right"},
    {Command::PageUp, {"Page-Up", "R Page-Up", "Page-Up"}},
    {Command::PageDown, {"Page-Down", "F Page-Down", "Page-Down"}},
}};

}  // namespace

Bindings default_bindings(Hands hands) {
    Bindings bindings;
    for (const DefaultInputs& row : kDefaults) {
        const std::string_view keys = row.keys[as_size(hands)];
        set_inputs(bindings, row.action, std::string(keys) + " " + std::string(row.common));
    }
    return bindings;
}

}  // namespace oblong

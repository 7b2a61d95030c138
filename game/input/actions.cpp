#include "game/input/actions.h"

#include <array>

#include "engine/base/table.h"

namespace oblong {
namespace {

// The d-pad does the same as the arrow keys: it walks and turns, and operates an open panel. The right mouse button
// walks ahead, so that a mouse alone is enough for a level.
constexpr std::array<ActionRow, kActionCount> kActions{{
    {Action::Forward, "forward", "Walk ahead", "Walk", "W Up", "Mouse-2 Pad-Up Pad-Left-Stick-Up", "W", "Up Keypad-8"},
    {Action::Left, "left", "Step left", "Walk", "A", "Pad-Left-Stick-Left", "A", "Delete Keypad-7"},
    {Action::Back, "back", "Walk back", "Walk", "S Down", "Pad-Down Pad-Left-Stick-Down", "S", "Down Keypad-2"},
    {Action::Right, "right", "Step right", "Walk", "D", "Pad-Left-Stick-Right", "D", "End Keypad-9"},
    {Action::TurnLeft, "turn-left", "Turn left", "Turn; or by the mouse", "Left", "Pad-Left Pad-Right-Stick-Left", "Q",
     "Left Keypad-4"},
    {Action::TurnRight, "turn-right", "Turn right", "Turn; or by the mouse", "Right", "Pad-Right Pad-Right-Stick-Right",
     "E", "Right Keypad-6"},
    {Action::LookUp, "look-up", "Look up", "", "Page-Up", "Pad-Right-Stick-Up", "R", "Page-Up Keypad-3"},
    {Action::LookDown, "look-down", "Look down", "", "Page-Down", "Pad-Right-Stick-Down", "F", "Page-Down Keypad-1"},
    {Action::Jump, "jump", "Jump, swim up", "Jump, swim up", "Space", "Mouse-3 Pad-A Pad-Right-Trigger", "Space",
     "Right-Ctrl Keypad-0"},
    {Action::WalkSlowly, "walk-slowly", "Walk slowly", "Walk slowly", "Left-Shift Right-Shift", "Pad-Left-Trigger",
     "Left-Shift", "Right-Shift Keypad-5"},
    {Action::Automap, "map", "Map", "Map", "Tab", "Pad-Back", "Tab", "Tab Keypad-Enter"},
    {Action::Torch, "torch", "Torch", "Torch", "L", "Pad-B"},
    {Action::Menu, "menu", "Menu, like Esc", "Menu", "", "Mouse-5"},
    {Action::QuickSave, "quick-save", "Quick save", "Quick save", "Insert"},
    {Action::QuickLoad, "quick-load", "Quick load", "Quick load", "Home"},
    {Action::Respawn, "respawn", "Back to the start", "Back to the start", "R", "Pad-Y", "T", "Keypad-Period"},
    {Action::Restart, "restart", "Restart the level", "Restart the level", "Backspace"},
    {Action::ProjectionAspect, "projection-aspect", "Aspect: projection", "Drawn for: projection", "F2",
     "Pad-Left-Shoulder"},
    {Action::DisplayAspect, "display-aspect", "Aspect: display", "Shown as: display", "F3", "Pad-Right-Shoulder"},
    {Action::AccuracyTier, "accuracy", "Accuracy", "Next accuracy", "F4", "Pad-X"},
    {Action::ScalingMode, "scaling", "Scaling", "Scaling", "F5"},
    {Action::FrameCost, "frame-cost", "Frame cost", "Frame cost", "F6"},
    {Action::LabPanel, "lab", "Lab", "Lab: dials", "F7", "Pad-Left-Stick"},
    {Action::ErrorMap, "error-map", "Error map", "Error map", "F8"},
    {Action::SplitView, "split", "Split: now and exact", "Split: now and exact", "F9"},
    {Action::FlipSettings, "flip", "Flip: now and before", "Flip: now and before", "F10"},
    {Action::AspectGuide, "aspect-guide", "Circle and square", "Circle and square", "F11"},
    {Action::Screenshot, "screenshot", "Screenshots", "Screenshots", "F12"},
    {Action::FourAspects, "four-aspects", "Four aspects", "Four aspects", "4"},
    {Action::Wireframe, "wireframe", "Wireframe", "Wireframe", "E", "", "X"},
    {Action::Isometric, "isometric", "Isometric view", "Isometric view", "I"},
    {Action::Inspect, "inspect", "Inspect a surface", "Inspect a surface", "P", "Pad-Right-Stick"},
    {Action::ZoomIn, "zoom-in", "Zoom in, move back", "Zoom and dolly", "Left-Bracket"},
    {Action::ZoomOut, "zoom-out", "Zoom out, move on", "Zoom and dolly", "Right-Bracket"},
    {Action::CrtLook, "crt", "CRT look", "CRT look", "C"},
    {Action::Darker, "darker", "Darker", "Brightness", "Minus"},
    {Action::Brighter, "brighter", "Brighter", "Brightness", "Equals"},
    {Action::Log, "log", "Log", "Log", "O"},
    {Action::ShowHelp, "help", "Keys", "These keys", "F1"},
    {Action::DialUp, "dial-up", "Panel: row above", "", "Up", "Pad-Up", "W Up", "Up Keypad-8"},
    {Action::DialDown, "dial-down", "Panel: row below", "", "Down", "Pad-Down", "S Down", "Down Keypad-2"},
    {Action::DialCoarser, "dial-coarser", "Panel: less", "", "Left", "Pad-Left", "A Left", "Left Keypad-4"},
    {Action::DialFiner, "dial-finer", "Panel: more", "", "Right", "Pad-Right", "D Right", "Right Keypad-6"},
    {Action::PageUp, "page-up", "Gallery: row before", "", "Page-Up", "", "R Page-Up"},
    {Action::PageDown, "page-down", "Gallery: next row", "", "Page-Down", "", "F Page-Down"},
}};

constexpr bool is_in_order() {
    for (std::size_t i = 0; i < kActions.size(); ++i)
        if (as_size(kActions[i].action) != i) return false;
    return true;
}
static_assert(is_in_order());

}  // namespace

std::span<const ActionRow> all_actions() {
    return kActions;
}

}  // namespace oblong

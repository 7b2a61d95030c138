#include "game/input/bindings.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "game/input/controls.h"

namespace oblong {
namespace {

bool is_apart(Action a, Action b) {
    return (is_move(a) && is_of_panel(b)) || (is_of_panel(a) && is_move(b));
}

std::vector<Input> parsed(std::string_view text) {
    std::vector<Input> inputs;
    if (text == "none") return inputs;
    for (std::string_view name = take_word(text); !name.empty(); name = take_word(text)) {
        inputs.push_back(input_named(name));
        if (is_reserved(inputs.back()))
            throw InputError("input", "'" + name_of(inputs.back()) + "' always opens the menu, expected another one");
    }
    if (inputs.size() > Bindings::kMostInputs)
        throw InputError("inputs", std::to_string(inputs.size()) + " of them, expected at most " +
                                       std::to_string(Bindings::kMostInputs));
    return inputs;
}

constexpr Input kEscape{Device::Key, 41}, kEnter{Device::Key, 40};

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
    {Action::Jump, "jump", "Jump, swim up", "Jump, swim up", "Space", "Mouse-3 Pad-A", "Space", "Right-Ctrl Keypad-0"},
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
    {Action::AccuracyTier, "accuracy", "Accuracy", "Next accuracy", "F4"},
    {Action::Exhibit, "exhibit", "The exhibit's dial", "The exhibit's dial", "V", "Pad-X"},
    {Action::Machine, "machine", "Machine", "Next machine", "M", "Pad-Right-Trigger"},
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
    {Action::ZoomIn, "zoom-in", "Zoom in, move back", "Zoom in, move back", "Left-Bracket"},
    {Action::ZoomOut, "zoom-out", "Zoom out, move on", "Zoom out, move on", "Right-Bracket"},
    {Action::CrtLook, "crt", "CRT look", "CRT look", "C"},
    {Action::SmallerView, "smaller-view", "Smaller view", "Smaller view", "Minus"},
    {Action::LargerView, "larger-view", "Larger view", "Larger view", "Equals"},
    {Action::Darker, "darker", "Darker", "Darker", "Comma"},
    {Action::Brighter, "brighter", "Brighter", "Brighter", "Period"},
    {Action::Log, "log", "Log", "Log", "O"},
    {Action::ShowHelp, "help", "Keys", "These keys", "F1"},
    {Action::DialUp, "dial-up", "Panel: row above", "", "Up", "Pad-Up", "W Up", "Up Keypad-8"},
    {Action::DialDown, "dial-down", "Panel: row below", "", "Down", "Pad-Down", "S Down", "Down Keypad-2"},
    {Action::DialCoarser, "dial-coarser", "Panel: less", "", "Left", "Pad-Left", "A Left", "Left Keypad-4"},
    {Action::DialFiner, "dial-finer", "Panel: more", "", "Right", "Pad-Right", "D Right", "Right Keypad-6"},
    {Action::PageUp, "page-up", "Gallery: row before", "", "Page-Up", "", "R Page-Up"},
    {Action::PageDown, "page-down", "Gallery: next row", "", "Page-Down", "", "F Page-Down"},
}};

// The inputs of each MenuAction, in any order.
constexpr std::array<std::string_view, 6> kMenuInputs{"W Up Keypad-8 Wheel-Up Pad-Up Pad-Left-Stick-Up",
                                                      "S Down Keypad-2 Wheel-Down Pad-Down Pad-Left-Stick-Down",
                                                      "A Left Keypad-4 Pad-Left Pad-Left-Stick-Left",
                                                      "D Right Keypad-6 Pad-Right Pad-Left-Stick-Right",
                                                      "Enter Keypad-Enter Space Pad-A",
                                                      "Backspace Pad-B"};

std::map<Input, MenuAction> read_menu_inputs() {
    std::map<Input, MenuAction> actions;
    for (std::size_t action = 0; action < kMenuInputs.size(); ++action)
        for (const Input input : parsed(kMenuInputs[action])) actions[input] = static_cast<MenuAction>(action);
    return actions;
}

constexpr bool is_in_order() {
    for (std::size_t i = 0; i < kActions.size(); ++i)
        if (as_size(kActions[i].action) != i) return false;
    return true;
}
static_assert(is_in_order());

std::vector<KeyHelp> with_keys(std::vector<KeyHelp> help, const KeyNames& names) {
    for (KeyHelp& line : help)
        for (const Action action : line.actions) line.keys += (line.keys.empty() ? "" : " ") + names.of(action);
    return help;
}

}  // namespace

std::span<const ActionRow> all_actions() {
    return kActions;
}

void Bindings::bind(Action action, Input input) {
    std::vector<Input>& inputs = inputs_[as_size(action)];
    if (is_reserved(input) || std::find(inputs.begin(), inputs.end(), input) != inputs.end()) return;
    if (inputs.size() == kMostInputs) inputs.erase(inputs.begin());
    inputs.push_back(input);
}

Bindings default_bindings(Hands hands) {
    Bindings bindings;
    for (const ActionRow& row : all_actions()) {
        const std::string_view keys = hands == Hands::Left    ? row.left_hand
                                      : hands == Hands::Right ? row.right_hand
                                                              : row.keys;
        set_inputs(bindings, row.action, std::string(keys) + " " + std::string(row.others));
    }
    return bindings;
}

std::vector<Conflict> conflicts_of(const Bindings& bindings) {
    std::vector<Conflict> all;
    for (const ActionRow& row : all_actions())
        for (const Input input : bindings.inputs_of(row.action)) {
            const auto known =
                std::find_if(all.begin(), all.end(), [&](const Conflict& c) { return c.input == input; });
            if (known == all.end())
                all.push_back({input, {row.action}});
            else
                known->actions.push_back(row.action);
        }
    std::erase_if(all, [](Conflict& conflict) {
        const auto clashes = [&](Action a) {
            return std::any_of(conflict.actions.begin(), conflict.actions.end(),
                               [&](Action b) { return a != b && !is_apart(a, b); });
        };
        return std::none_of(conflict.actions.begin(), conflict.actions.end(), clashes);
    });
    return all;
}

std::string inputs_to_text(const Bindings& bindings, Action action) {
    std::string text;
    for (const Input input : bindings.inputs_of(action)) {
        std::string name = name_of(input);
        std::replace(name.begin(), name.end(), ' ', '-');
        text += (text.empty() ? "" : " ") + name;
    }
    return text.empty() ? "none" : text;
}

void set_inputs(Bindings& bindings, Action action, std::string_view text) {
    const std::vector<Input> inputs = parsed(text);
    bindings.unbind_all(action);
    for (const Input input : inputs) bindings.bind(action, input);
}

std::string KeyNames::of(Action action) const {
    if (action == Action::Menu)  // not from the bindings
        return platform_.local_name_of(uses_pad_ ? pad_button(PadButton::Start) : kEscape);
    const std::span<const Input> inputs = bindings_.inputs_of(action);
    if (inputs.empty()) return "none";
    const auto found =
        std::find_if(inputs.begin(), inputs.end(), [&](Input input) { return is_of_pad(input) == uses_pad_; });
    return platform_.local_name_of(found == inputs.end() ? inputs.front() : *found);
}

// Empty if the name is unknown.
std::string KeyNames::of(std::string_view name) const {
    if (name == "choose")
        return uses_pad_ ? "Stick" : platform_.local_name_of(input_named("Up")).empty() ? "Taps" : "Arrows";
    if (name == "accept") return platform_.local_name_of(uses_pad_ ? pad_button(PadButton::A) : kEnter);
    const auto actions = all_actions();
    const auto found =
        std::find_if(actions.begin(), actions.end(), [&](const ActionRow& row) { return row.name == name; });
    if (found == actions.end()) return "";
    const std::string key = of(found->action);
    return key.empty() ? of(Action::Menu) + ", Keys" : key;
}

std::string KeyNames::in(const std::string& text) const {
    std::string shown;
    std::string_view rest = text;
    for (std::size_t open = 0; (open = rest.find('{')) != std::string_view::npos;) {
        const std::size_t close = rest.find('}', open);
        if (close == std::string_view::npos) break;
        const std::string name = of(rest.substr(open + 1, close - open - 1));
        shown += rest.substr(0, open);
        shown += name.empty() ? std::string(rest.substr(open, close - open + 1)) : name;
        rest.remove_prefix(close + 1);
    }
    return shown + std::string(rest);
}

std::optional<MenuAction> menu_action_of(Input input) {
    static const std::map<Input, MenuAction> actions = read_menu_inputs();
    const auto found = actions.find(input);
    return found == actions.end() ? std::nullopt : std::optional(found->second);
}

std::vector<KeyHelp> game_help(const KeyNames& names) {
    std::vector<KeyHelp> help;
    for (const ActionRow& row : all_actions()) {
        if (row.help.empty()) continue;
        if (help.empty() || help.back().label != row.help) help.push_back({std::string(row.help), "", {}});
        help.back().actions.push_back(row.action);
    }
    return with_keys(std::move(help), names);
}

std::vector<KeyHelp> gallery_help(const KeyNames& names) {
    return with_keys({{"Next row", "", {Action::PageDown}},
                      {"Row before", "", {Action::PageUp}},
                      {"Choose a parameter", "", {Action::DialUp, Action::DialDown}},
                      {"Change it", "", {Action::DialCoarser, Action::DialFiner}},
                      {"All figures", "", {Action::FrameCost}},
                      {"Next accuracy", "", {Action::AccuracyTier}},
                      {"Drawn for: projection", "", {Action::ProjectionAspect}},
                      {"Shown as: display", "", {Action::DisplayAspect}},
                      {"Scaling", "", {Action::ScalingMode}},
                      {"CRT look", "", {Action::CrtLook}},
                      {"Screenshots", "", {Action::Screenshot}},
                      {"Back", "", {Action::Menu}},
                      {"These keys", "", {Action::ShowHelp}}},
                     names);
}

}  // namespace oblong

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/table.h"
#include "engine/platform/input.h"
#include "engine/platform/platform.h"

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
    Exhibit,  ///< turns the dial that the place asks for
    Machine,
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
    SmallerView,
    LargerView,
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

/// The inputs of each action. Two are equal if every action has the same inputs.
class Bindings {
  public:
    static constexpr std::size_t kMostInputs = 6;  ///< of an action

    std::span<const Input> inputs_of(Action action) const { return inputs_[as_size(action)]; }

    /// Adds an input; it replaces the first one if the action has kMostInputs. Does nothing if the action has it
    /// already or the input is_reserved(). Other actions keep it: see conflicts_of().
    void bind(Action action, Input input);
    void unbind(Action action, Input input) { std::erase(inputs_[as_size(action)], input); }
    void unbind_all(Action action) { inputs_[as_size(action)].clear(); }

    bool operator==(const Bindings&) const = default;

  private:
    std::array<std::vector<Input>, kActionCount> inputs_;
};

/// The hands that a keyboard is bound for: both, or one that reaches all keys needed to walk.
enum class Hands : std::uint8_t { Both, Left, Right };
inline constexpr int kHandsCount = 3;

/// The default bindings. Mouse and gamepad are the same in all three.
Bindings default_bindings(Hands hands = Hands::Both);

/// An input that triggers two actions at once.
struct Conflict {
    Input input;
    std::vector<Action> actions;  ///< at least two
};

/// All conflicts. A key bound to a panel action (lab, gallery) and to a move is no conflict: it operates the panel
/// while that is open, and moves otherwise.
std::vector<Conflict> conflicts_of(const Bindings& bindings);

/// The inputs of an action for the options file: "W Up Pad-Left-Stick-Up", "none".
std::string inputs_to_text(const Bindings& bindings, Action action);

/// Replaces the inputs of an action by those of a text from inputs_to_text(). Throws InputError for an unknown name, a
/// reserved input or more than kMostInputs, and changes nothing then.
void set_inputs(Bindings& bindings, Action action, std::string_view text);

/// The names of keys and buttons in texts for the player: as they are bound, and for the device in use. All texts use
/// it.
class KeyNames {
  public:
    /// All outlive it. `uses_pad`: the player's last input was a gamepad's.
    KeyNames(const Bindings& bindings, const Platform& platform, bool uses_pad)
        : bindings_(bindings), platform_(platform), uses_pad_(uses_pad) {}

    /// The first input of an action on the device in use, else on another device: "F2"; "none" if there is none; empty
    /// if a touch screen is in use that has no button for it.
    std::string of(Action action) const;
    /// Replaces the names of actions in braces by those of their keys: "{accuracy}" by "F4". {choose} and {accept} are
    /// the inputs of menus. An action without a button is reached by the page of keys: "Menu, Keys". Unknown names stay
    /// as they are.
    std::string in(const std::string& text) const;

  private:
    std::string of(std::string_view name) const;

    const Bindings& bindings_;
    const Platform& platform_;
    const bool uses_pad_;
};

/// A line on the page of keys.
struct KeyHelp {
    std::string label;  ///< "Walk"
    std::string keys;   ///< "W A S D"
    std::vector<Action> actions;
};
std::vector<KeyHelp> game_help(const KeyNames& names);
std::vector<KeyHelp> gallery_help(const KeyNames& names);

}  // namespace oblong

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/platform/platform.h"
#include "game/input/actions.h"

namespace oblong {

/// The inputs of each action. Two are equal if every action has the same inputs.
class Bindings {
  public:
    static constexpr std::size_t kMostInputs = 6;  ///< of an action

    std::span<const Input> inputs_of(Action action) const;

    /// Adds an input; it replaces the first one if the action has kMostInputs. Does nothing if the action has it
    /// already or the input is_reserved(). Other actions keep it: see conflicts_of().
    void bind(Action action, Input input);
    void unbind(Action action, Input input);
    void unbind_all(Action action);

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

    /// The first input of an action on the device in use, else on another device: "F2"; "none" if there is none.
    std::string of(Action action) const;
    /// Replaces the names of actions in braces by those of their keys: "{accuracy}" by "F4". {choose} and {accept} are
    /// the inputs of menus. Unknown names stay as they are.
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
};
std::vector<KeyHelp> game_help(const KeyNames& names);
std::vector<KeyHelp> gallery_help(const KeyNames& names);

}  // namespace oblong

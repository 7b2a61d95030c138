#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/input/actions.h"

namespace oblong {

/// Which inputs do what. A value: equal where every action has the same inputs.
class Bindings {
  public:
    static constexpr std::size_t kMostInputs = 6;  ///< of an action

    std::span<const Input> inputs_of(Action action) const;

    /// Adds an input; in place of the first one where the action has kMostInputs. Nothing where the action has it
    /// already or the input is_reserved(). Other actions keep it: see conflicts_of().
    void bind(Action action, Input input);
    void unbind(Action action, Input input);
    void unbind_all(Action action);

    bool operator==(const Bindings&) const = default;

  private:
    std::array<std::vector<Input>, kActionCount> inputs_;
};

/// For which hands a keyboard is bound: both, or one that reaches all that a walk needs.
enum class Hands : std::uint8_t { Both, Left, Right };
inline constexpr int kHandsCount = 3;

/// The bindings that a game begins with. Mouse and gamepad are the same in all three.
Bindings default_bindings(Hands hands = Hands::Both);

/// An input that does two things at once.
struct Conflict {
    Input input;
    std::vector<Action> actions;  ///< at least two
};

/// All of them. What a key does in a panel (the lab's dials, the gallery) is no conflict with a movement: while the
/// panel is open the key works it, and else it moves.
std::vector<Conflict> conflicts_of(const Bindings& bindings);

/// The inputs of an action for the options file: "W Up Pad-Left-Stick-Up", "none".
std::string inputs_to_text(const Bindings& bindings, Action action);

/// Binds an action to what inputs_to_text() wrote, and to nothing else. Throws InputError for an unknown name, a
/// reserved input or more than kMostInputs, and changes nothing then.
void set_inputs(Bindings& bindings, Action action, std::string_view text);

}  // namespace oblong

#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include "engine/platform/input.h"
#include "game/input/bindings.h"

namespace oblong {

/// A set of moves: actions for which is_move() is true.
class Moves {
  public:
    constexpr Moves() = default;
    constexpr Moves(std::initializer_list<Action> moves) {
        for (const Action move : moves) set(move);
    }

    constexpr bool has(Action move) const { return (bits_ & bit(move)) != 0; }
    constexpr void set(Action move, bool is_on = true) {
        bits_ = static_cast<std::uint16_t>(is_on ? bits_ | bit(move) : bits_ & ~bit(move));
    }
    /// 1 if only the first is held, -1 if only the second is, else 0.
    constexpr int direction(Action positive, Action negative) const { return int{has(positive)} - int{has(negative)}; }

    constexpr Moves& operator|=(Moves others) {
        bits_ |= others.bits_;
        return *this;
    }
    /// The moves that are not in `others`.
    constexpr Moves without(Moves others) const {
        Moves rest;
        rest.bits_ = static_cast<std::uint16_t>(bits_ & ~others.bits_);
        return rest;
    }
    bool operator==(const Moves&) const = default;

  private:
    static constexpr std::uint16_t bit(Action move) { return static_cast<std::uint16_t>(1u << static_cast<int>(move)); }
    std::uint16_t bits_ = 0;
    static_assert(kMoveCount <= 16);
};

/// The player's actions in a menu. Each is reported when it is pressed; directions repeat while they are held.
enum class MenuAction : std::uint8_t { Up, Down, Left, Right, Accept, Back };

/// What an input does in every menu, whatever the bindings.
std::optional<MenuAction> menu_action_of(Input input);

/// The input with which a script does it, as scripted(Action).
constexpr Input scripted(MenuAction action) {
    return {Device::Script, static_cast<std::uint16_t>(kActionCount + static_cast<int>(action))};
}

/// A stick's position as the device reports it, -kFullAxis to kFullAxis, no dead zone applied.
struct Stick {
    std::int32_t x = 0, y = 0;  ///< right and up positive

    bool operator==(const Stick&) const = default;
};

/// The player's input between two polls: inputs held now or pressed since the last poll, and mouse motion since then.
struct Controls : WindowInput {
    Moves moves;
    Moves panel_moves;  ///< from keys that operate an open panel (by default the arrow keys), and move if none is open
    Stick walk_stick, look_stick;           ///< y: ahead, up
    bool holds_button = false;              ///< the first button of the captured mouse
    std::int32_t mouse_x = 0, mouse_y = 0;  ///< device counts, right and down positive
    std::vector<Action> commands;
    std::vector<MenuAction> menu;
    std::optional<Input> pressed;  ///< the last of all inputs that were pressed, bound or not

    bool has(Action command) const;
};

}  // namespace oblong

#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include "engine/platform/input_events.h"
#include "game/input/actions.h"

namespace oblong {

/// A set of moves: actions that is_move() says are on while they are held.
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
    /// 1 while the first is held alone, -1 while the second is, else 0.
    constexpr int direction(Action positive, Action negative) const { return int{has(positive)} - int{has(negative)}; }

    constexpr Moves& operator|=(Moves others) {
        bits_ |= others.bits_;
        return *this;
    }
    /// Those that the other set lacks.
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

/// What the player does in a menu. Each is reported when it is pressed, directions again and again while they are held.
enum class MenuAction : std::uint8_t { Up, Down, Left, Right, Accept, Back };

/// The input by which a script does it, as scripted(Action).
constexpr Input scripted(MenuAction action) {
    return {Device::Script, static_cast<std::uint16_t>(kActionCount + static_cast<int>(action))};
}

/// A stick's place, -kFullAxis to kFullAxis: without a dead zone, as the device reports it.
struct Stick {
    std::int32_t x = 0, y = 0;  ///< right and up positive

    bool operator==(const Stick&) const = default;
};

/// The player's input between two polls: what is held now or was pressed since the last poll, and mouse motion since.
struct Controls : WindowInput {
    Moves moves;
    Moves panel_moves;  ///< by keys that work an open panel (by default the arrow keys) and move while none is open
    Stick walk_stick, look_stick;           ///< y: ahead, up
    bool holds_button = false;              ///< the first button of the captured mouse
    std::int32_t mouse_x = 0, mouse_y = 0;  ///< counts of the device, right and down positive
    std::vector<Action> commands;
    std::vector<MenuAction> menu;
    std::optional<Input> pressed;  ///< the last of all inputs that were pressed, bound or not

    bool has(Action command) const;
};

/// A stick without its dead zone, a circle of `dead_zone_100` percent (0 to 90) of its way round the middle, in which
/// it is at rest: from there on it rises from 0, to the full length at 97 % of the way, which worn sticks still reach.
/// The direction stays.
Stick without_dead_zone(Stick stick, std::int32_t dead_zone_100);

/// Finer near the middle: as long as the square of its length, both as parts of the full one.
Stick squared(Stick stick);

}  // namespace oblong

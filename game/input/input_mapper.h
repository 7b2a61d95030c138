#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "game/input/bindings.h"
#include "game/input/controls.h"

namespace oblong {

/// Turns inputs that are pressed and released into Controls, by bindings. Menus are worked by fixed inputs: arrow keys,
/// WASD, keypad, Enter, Space, Backspace, wheel, the pad's cross and left stick, A and B.
class InputMapper {
  public:
    /// `bindings`, which may change, outlive the mapper.
    explicit InputMapper(const Bindings& bindings) : bindings_(bindings) {}

    void press(Input input);
    /// What the system reports again and again while a key is held.
    void repeat(Input input);
    void release(Input input);
    /// A half of an axis, 0 to kFullAxis. Past half of its way it is pressed too.
    void move_axis(Input half, std::int32_t value);
    /// A press by a mouse that points at a menu: its first two buttons do nothing here but that the second one goes
    /// back.
    void click(Input button);
    void release_all();
    void release_pressed();  ///< but sticks stay where they are
    void release_pad();
    void move_mouse(std::int32_t x, std::int32_t y);

    /// What happened since the last call, and what is held. `now_ms` is of any clock: inputs of a pad are repeated by
    /// it.
    Controls take(std::uint64_t now_ms);
    /// The same after what a platform reports.
    Controls take(const PlatformInput& input, std::uint64_t now_ms);

    /// How long the next take() may be put off without a repetition being late.
    std::int32_t longest_wait_ms() const;

    bool holds(Input input) const;

  private:
    void take(const InputEvent& event);
    void act(Input input, bool is_repeated);
    void repeat_pad(std::uint64_t now_ms);
    std::int32_t axis_of(Action move) const;
    bool is_on(Action move, bool by_panel_keys) const;
    Moves moves(bool by_panel_keys) const;

    const Bindings& bindings_;
    std::vector<Input> held_, tapped_;  // tapped: pressed since the last take()
    std::array<std::int32_t, kAxisHalfCount> axes_{};
    std::optional<Input> pad_input_;  // that was pressed last and is held
    std::uint64_t repeat_at_ms_ = 0;  // of pad_input_; 0: not yet known
    Controls since_;                  // what happened since the last take()
};

}  // namespace oblong

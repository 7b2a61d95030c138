#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "game/input/bindings.h"
#include "game/input/controls.h"

namespace oblong {

/// Turns pressed and released inputs into Controls, by bindings. Menus have fixed inputs: arrow keys, WASD, keypad,
/// Enter, Space, Backspace, wheel, the d-pad, left stick, A and B of a pad.
class InputMapper {
  public:
    /// `bindings` may change, and outlive the mapper.
    explicit InputMapper(const Bindings& bindings) : bindings_(bindings) {}

    void press(Input input);
    /// A repetition that the system reports while a key is held.
    void repeat(Input input);
    void release(Input input);
    /// A half of an axis, 0 to kFullAxis. Beyond half of its range it counts as pressed.
    void move_axis(Input half, std::int32_t value);
    /// A press by a mouse that points at a menu: the second button goes back, the first one does nothing here.
    void click(Input button);
    void release_all();
    void release_pressed();  ///< keeps the positions of sticks
    void release_pad();
    void move_mouse(std::int32_t x, std::int32_t y);

    /// The inputs since the last call, and those still held. `now_ms` is of any clock; it times the repetition of pad
    /// inputs.
    Controls take(std::uint64_t now_ms);
    /// The same, after the events that a platform reports.
    Controls take(const PlatformInput& input, std::uint64_t now_ms);

    /// The longest time until the next take() with no repetition late.
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
    std::optional<Input> pad_input_;  // the last one pressed, while it is held
    std::uint64_t repeat_at_ms_ = 0;  // of pad_input_; 0: not yet set
    Controls since_;                  // what happened since the last take()
};

}  // namespace oblong

#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace oblong {

/// The device of an input.
enum class Device : std::uint8_t {
    Key,          ///< code: the key's place, a USB HID usage: 4 is A on a US keyboard
    MouseButton,  ///< code: 1 left, 2 right, 3 middle, 4 and on: others
    MouseWheel,   ///< code: a WheelTurn
    PadButton,    ///< code: a PadButton
    PadAxis,      ///< code: a half of an axis, see pad_axis()
    Script        ///< pressed by the program; the code is its own
};

enum class WheelTurn : std::uint16_t { Up, Down, Left, Right };

/// The buttons of a gamepad, as SDL numbers them: A is the button of that name, or the lowest of the four.
enum class PadButton : std::uint16_t {
    A,
    B,
    X,
    Y,
    Back,
    Guide,
    Start,
    LeftStick,  ///< pressed down
    RightStick,
    LeftShoulder,
    RightShoulder,
    Up,
    Down,
    Left,
    Right,
    Misc,
    Paddle1,
    Paddle2,
    Paddle3,
    Paddle4,
    Touchpad
};

enum class PadAxis : std::uint16_t { LeftX, LeftY, RightX, RightY, LeftTrigger, RightTrigger };
inline constexpr int kAxisHalfCount = 12;  ///< codes of pad_axis() are below this

/// A key, a button, a turn of the wheel, or a stick or trigger in one direction.
struct Input {
    Device device = Device::Key;
    std::uint16_t code = 0;

    auto operator<=>(const Input&) const = default;
};

/// The largest value of a half of an axis, as in SDL.
inline constexpr std::int32_t kFullAxis = 32'767;

/// Half of an axis: towards right or down if `is_positive`, as in SDL. Triggers have positive halves only.
constexpr Input pad_axis(PadAxis axis, bool is_positive) {
    return {Device::PadAxis, static_cast<std::uint16_t>(2 * static_cast<int>(axis) + int{is_positive})};
}
constexpr Input pad_button(PadButton button) {
    return {Device::PadButton, static_cast<std::uint16_t>(button)};
}
constexpr Input mouse_button(std::uint16_t number) {
    return {Device::MouseButton, number};
}

constexpr bool is_of_pad(Input input) {
    return input.device == Device::PadButton || input.device == Device::PadAxis;
}

/// Whether the input always opens the menu and cannot be bound: Escape, a gamepad's Start.
bool is_reserved(Input input);

/// "W", "Left Shift", "Keypad 5", "Key 135", "Mouse 1", "Wheel Up", "Pad A", "Pad Left Stick Up". Keys are named after
/// a US keyboard, so that a name means the same place on every keyboard.
std::string name_of(Input input);
/// What a key of the user's keyboard is called that types this character: "W", "[", "ö". Empty if it is none of ASCII's
/// or Latin's.
std::string name_of_letter(std::int32_t code_point);

/// The input of such a name, in any case, with hyphens for spaces ("left-shift"). Throws InputError for an unknown
/// name.
Input input_named(std::string_view name);

/// An event of an input device.
struct InputEvent {
    enum class Kind : std::uint8_t {
        Press,
        Repeat,  ///< reported repeatedly while a key is held
        Release,
        Click,           ///< a press by the free mouse, which points; a Release follows
        Axis,            ///< `input`: a half of an axis, `x`: its value, 0 to kFullAxis
        MouseMotion,     ///< of the captured mouse, `x`, `y`: counts of the device, right and down positive
        ReleasePressed,  ///< of all keys and buttons; sticks keep their positions
        ReleasePad,      ///< of all inputs of the gamepad
        ReleaseAll
    };
    Kind kind = Kind::Press;
    Input input = {};
    std::int32_t x = 0, y = 0;

    bool operator==(const InputEvent&) const = default;
};

/// The free mouse, in pixels of the window.
struct Pointer {
    std::int32_t x_px = 0, y_px = 0;
    bool has_moved = false, is_pressed = false;  ///< since the last poll
};

/// The state of the window.
struct WindowInput {
    std::optional<Pointer> pointer;  ///< nothing if the mouse is captured, or there is none
    bool has_focus = true, is_minimised = false;
    bool changes_full_screen = false;  ///< Alt+Enter since the last poll: to the whole screen or back
};

/// The player's input since the last poll, in order.
struct PlatformInput : WindowInput {
    std::vector<InputEvent> events;
    /// Of each gamepad by itself, 256 times its number, from 1 on, added to codes; `events` have the one used last.
    std::vector<InputEvent> pad_events = {};
    std::string text = {};  ///< typed, in UTF-8, with '\b' for Backspace and '\n' for Enter
};

}  // namespace oblong

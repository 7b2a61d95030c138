#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/platform/input.h"

namespace oblong {

/// An event of an input device.
struct InputEvent {
    enum class Kind : std::uint8_t {
        Press,
        Repeat,  ///< reported repeatedly while a key is held
        Release,
        Click,           ///< a press by a mouse that points at a menu; has no release
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
};

}  // namespace oblong

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/platform/input.h"

namespace oblong {

/// Something that the player did with a device, or that ended it.
struct InputEvent {
    enum class Kind : std::uint8_t {
        Press,
        Repeat,  ///< what the system reports again and again while a key is held
        Release,
        Click,           ///< a press by a mouse that points at a menu; has no release
        Axis,            ///< `input`: a half of an axis, `x`: where it is, 0 to kFullAxis
        MouseMotion,     ///< of the captured mouse, `x`, `y`: counts of the device, right and down positive
        ReleasePressed,  ///< of all keys and buttons; sticks stay where they are
        ReleasePad,      ///< of all that a gamepad held
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

/// What the window is to the player now.
struct WindowInput {
    std::optional<Pointer> pointer;  ///< nothing while the mouse is captured, or where there is none
    bool has_focus = true, is_minimised = false;
    bool changes_full_screen = false;  ///< to the whole screen or back, since the last poll: Alt+Enter
};

/// What the player did since the last poll, in the order in which it happened.
struct PlatformInput : WindowInput {
    std::vector<InputEvent> events;
};

}  // namespace oblong

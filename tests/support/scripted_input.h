#pragma once

#include "game/input/controls.h"

namespace oblong::test {

/// What a platform reports of a player whose controls are these, whatever is bound. Not of keys that work panels.
inline PlatformInput scripted_input(const Controls& controls) {
    using Kind = InputEvent::Kind;
    PlatformInput input;
    static_cast<WindowInput&>(input) = controls;
    const auto press = [&](Input pressed) {
        input.events.push_back({Kind::Press, pressed, 0, 0});
        input.events.push_back({Kind::Release, pressed, 0, 0});
    };
    for (int i = 0; i < kMoveCount; ++i) {
        const auto move = static_cast<Action>(i);
        input.events.push_back({controls.moves.has(move) ? Kind::Press : Kind::Release, scripted(move), 0, 0});
    }
    for (const Action command : controls.commands) press(scripted(command));
    for (const MenuAction action : controls.menu) press(scripted(action));
    input.events.push_back({Kind::MouseMotion, {}, controls.mouse_x, controls.mouse_y});
    return input;
}

}  // namespace oblong::test

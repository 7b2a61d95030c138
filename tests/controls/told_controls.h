#pragma once

#include <gtest/gtest.h>

#include <string>

#include "game/input/controls.h"
#include "tests/support/script.h"

namespace oblong::test {

inline std::string text_of(const Moves& moves) {
    Words names;
    for (int i = 0; i < kMoveCount; ++i)
        if (const auto move = static_cast<Action>(i); moves.has(move)) names.emplace_back(row_of(move).name);
    return joined(names);
}

/// What controls are by name: "forward jump" of moves, panel and commands; "up accept" of menu; "-3000 20000" of walk,
/// look and mouse; "F20" of pressed; "100 200 moved pressed" of pointer; "yes" or "" of held and full_screen.
inline std::string told(const Controls& controls, const std::string& name) {
    constexpr const char* kMenu[] = {"up", "down", "left", "right", "accept", "back"};
    const auto pair = [](std::int32_t x, std::int32_t y) { return std::to_string(x) + " " + std::to_string(y); };
    Words names;
    if (name == "moves") return text_of(controls.moves);
    if (name == "panel") return text_of(controls.panel_moves);
    if (name == "commands")
        for (const Action action : controls.commands) names.emplace_back(row_of(action).name);
    if (name == "menu")
        for (const MenuAction action : controls.menu) names.emplace_back(kMenu[static_cast<std::size_t>(action)]);
    if (name == "walk") return pair(controls.walk_stick.x, controls.walk_stick.y);
    if (name == "look") return pair(controls.look_stick.x, controls.look_stick.y);
    if (name == "mouse") return pair(controls.mouse_x, controls.mouse_y);
    if (name == "pressed") return controls.pressed ? name_of(*controls.pressed) : "";
    if (name == "held") return controls.holds_button ? "yes" : "";
    if (name == "full_screen") return controls.changes_full_screen ? "yes" : "";
    if (const auto& at = controls.pointer; name == "pointer" && at)
        return pair(at->x_px, at->y_px) + (at->has_moved ? " moved" : "") + (at->is_pressed ? " pressed" : "");
    return joined(names);
}

/// Tells of the controls that `take` gives after a line's actions, if it asks for any.
inline void check_controls(const ScriptLine& line, auto take) {
    SCOPED_TRACE(line.text);
    if (line.checks.empty()) return;
    const Controls controls = take();
    for (const Words& words : line.checks) EXPECT_EQ(told(controls, words.at(0)), joined(words, 2)) << words[0];
}

}  // namespace oblong::test

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/platform/input.h"
#include "engine/platform/sdl/owned.h"

namespace oblong {

/// The connected gamepads. The one used last is active. No pad is polled: SDL reports changes.
class GamePads {
  public:
    /// If SDL's gamepad support fails, writes a line on standard error, and there are no pads.
    GamePads();
    ~GamePads();
    GamePads(const GamePads&) = delete;
    GamePads& operator=(const GamePads&) = delete;

    /// Adds the events of the pad used last, and to `of_each` those of all (PlatformInput::pad_events); ignores other
    /// events. A pad unknown to SDL is ignored, with a line on standard error.
    void take(const SDL_Event& event, std::vector<InputEvent>& events, std::vector<InputEvent>& of_each);

    /// The name of an input on the pad used last ("Cross", "L1"); without a pad, name_of().
    std::string local_name_of(Input input) const;

  private:
    struct Pad {
        std::int32_t id, number;
        Owned<SDL_GameController> controller;
    };

    void add(std::int32_t device_index);
    void remove(std::int32_t id, std::vector<InputEvent>& events);
    Input numbered(Input input, std::int32_t id) const;
    void take_button(const SDL_ControllerButtonEvent& event, std::vector<InputEvent>& events,
                     std::vector<InputEvent>& of_each);
    void take_axis(const SDL_ControllerAxisEvent& event, std::vector<InputEvent>& events,
                   std::vector<InputEvent>& of_each);
    void use_pad(std::int32_t id, std::vector<InputEvent>& events);

    bool is_available_ = false;
    std::vector<Pad> pads_;
    static constexpr std::int32_t kNone = -1;
    std::int32_t used_ = kNone;  // id of the pad used last
};

/// The keyboard, the mouse and the gamepads of a window. Losing the focus frees the mouse and releases all inputs;
/// Alt+Enter toggles the whole screen.
class SdlInput {
  public:
    explicit SdlInput(SDL_Window* window);

    /// All that SDL reported since the last poll.
    PlatformInput poll();
    /// The name of an input on the user's keyboard or the pad used last.
    std::string local_name_of(Input input) const;
    /// Also releases keys and buttons, so that presses in a menu do not reach the game.
    void capture_mouse(bool is_captured);
    bool is_closed() const { return is_closed_; }
    /// True once after the renderer lost its textures.
    bool take_textures_lost() { return std::exchange(are_textures_lost_, false); }

  private:
    void take(const SDL_Event& event);
    void take_key(const SDL_KeyboardEvent& key);
    void take_button(const SDL_MouseButtonEvent& button);
    void take_wheel(const SDL_MouseWheelEvent& wheel);
    void take_motion(const SDL_MouseMotionEvent& motion);
    void take_window_event(std::uint8_t event);
    void note(InputEvent::Kind kind, Input input = {}) { events_.push_back({kind, input, 0, 0}); }
    void point_at(std::int32_t x, std::int32_t y);

    SDL_Window* window_;
    std::vector<InputEvent> events_, pad_events_;  // since the last poll
    std::string text_;
    GamePads pads_;
    bool is_closed_ = false, are_textures_lost_ = false, changes_full_screen_ = false;
    std::optional<Pointer> pointer_;
};

}  // namespace oblong

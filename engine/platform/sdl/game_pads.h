#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/platform/input.h"

struct _SDL_GameController;
struct SDL_ControllerAxisEvent;
struct SDL_ControllerButtonEvent;
union SDL_Event;

namespace oblong {

/// The connected gamepads. The one used last is active. No pad is polled: SDL reports changes.
class GamePads {
  public:
    /// If SDL's gamepad support fails, writes a line on standard error, and there are no pads.
    GamePads();
    ~GamePads();
    GamePads(const GamePads&) = delete;
    GamePads& operator=(const GamePads&) = delete;

    /// Adds the events of gamepads; ignores other events. A pad unknown to SDL is ignored, with a line on standard
    /// error.
    void take(const SDL_Event& event, std::vector<InputEvent>& events);

    /// The name of an input on the pad used last ("Cross", "L1"); without a pad, name_of().
    std::string local_name_of(Input input) const;

  private:
    struct Close {
        void operator()(_SDL_GameController* controller) const;
    };
    struct Pad {
        std::int32_t id;
        std::unique_ptr<_SDL_GameController, Close> controller;
    };

    void add(std::int32_t device_index);
    void remove(std::int32_t id, std::vector<InputEvent>& events);
    void take_button(const SDL_ControllerButtonEvent& event, std::vector<InputEvent>& events);
    void take_axis(const SDL_ControllerAxisEvent& event, std::vector<InputEvent>& events);
    void use_pad(std::int32_t id, std::vector<InputEvent>& events);

    bool is_available_ = false;
    std::vector<Pad> pads_;
    static constexpr std::int32_t kNone = -1;
    std::int32_t used_ = kNone;  // id of the pad used last
};

}  // namespace oblong

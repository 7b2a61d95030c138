#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/platform/input_events.h"

struct _SDL_GameController;
struct SDL_ControllerAxisEvent;
struct SDL_ControllerButtonEvent;
union SDL_Event;

namespace oblong {

/// The gamepads that are plugged in, now or later. The one used last acts. Nothing asks a pad for its state: SDL
/// reports what changes, and without a pad nothing.
class GamePads {
  public:
    /// Without SDL's help for gamepads (an error there) a line on standard error, and no pads.
    GamePads();
    ~GamePads();
    GamePads(const GamePads&) = delete;
    GamePads& operator=(const GamePads&) = delete;

    /// Adds what the events of gamepads, and no others, say. A pad that SDL has no description of is ignored, with a
    /// line on standard error.
    void take(const SDL_Event& event, std::vector<InputEvent>& events);

    /// What the pad used last calls one of its inputs ("Cross", "L1"); without a pad, name_of().
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

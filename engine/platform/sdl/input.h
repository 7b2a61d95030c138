#pragma once

#include "engine/platform/controls.h"

struct SDL_Window;
union SDL_Event;
struct SDL_KeyboardEvent;

namespace oblong {

/// The keyboard and the mouse of a window. A click captures the mouse, Escape or losing the focus frees it; Escape with
/// a free mouse closes, Alt+Enter is the whole screen and back.
class SdlInput {
  public:
    explicit SdlInput(SDL_Window* window) : window_(window) {}

    /// Handles all pending events: motion and presses since the last poll, and the keys held now.
    Controls poll();
    void capture_mouse(bool is_captured);
    bool is_closed() const { return is_closed_; }
    /// True once after the renderer lost its textures.
    bool take_textures_lost();

  private:
    void take(const SDL_Event& event, Controls& controls);
    void take_key(const SDL_KeyboardEvent& key, Controls& controls);
    void toggle_fullscreen();
    void leave();

    SDL_Window* window_;
    bool is_closed_ = false, are_textures_lost_ = false;
};

}  // namespace oblong

#pragma once

#include <cstdint>

#include "engine/platform/controls.h"
#include "engine/platform/present_rect.h"
#include "engine/screen/screen.h"
#include "engine/surface/palette.h"

namespace oblong {

/// Input, clock and output of the game: a window (platform/sdl) or memory (platform/headless).
class Platform {
  public:
    virtual ~Platform() = default;

    virtual bool is_open() const = 0;            ///< false once the user has closed it, or the script has ended
    virtual Controls poll() = 0;                 ///< input since the last poll
    virtual std::uint64_t now_us() = 0;          ///< a clock that never runs backwards; starts anywhere
    virtual WindowSize window_size() const = 0;  ///< of the drawable, in pixels of the device
    virtual void set_title(const char* title) = 0;
    /// Whether the mouse turns the view and can't leave the window, or points at a menu.
    virtual void capture_mouse(bool /*is_captured*/) {}

    /// Shows the picture, in `shown` of the window, black around it. Waits for the display where it can.
    virtual void present(Framebuffer picture, const Palette& palette, const PresentRect& shown) = 0;
};

}  // namespace oblong

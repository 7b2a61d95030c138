#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/platform/input.h"
#include "engine/surface/palette.h"
#include "engine/view/present_rect.h"
#include "engine/view/screen.h"

namespace oblong {

/// The player's settings of the window.
struct WindowSettings {
    bool is_full_screen = false;
    bool waits_for_display = true;       ///< vsync: no more frames than the display shows, without tearing if possible
    std::int32_t frames_per_second = 0;  ///< at most; 0: no other limit than the display's

    bool operator==(const WindowSettings&) const = default;
};

/// Input, clock and output of the game: a window (platform/sdl), a web page's canvas
/// (platform/web) or memory (platform/headless).
class Platform {
  public:
    virtual ~Platform() = default;

    virtual bool is_open() const = 0;            ///< false once the user has closed it, or the script has ended
    virtual PlatformInput poll() = 0;            ///< since the last poll
    virtual std::uint64_t now_us() = 0;          ///< a monotonic clock with any start
    virtual WindowSize window_size() const = 0;  ///< of the drawable, in pixels of the device
    virtual void set_title(const char* title) = 0;
    /// The window's icon: four bytes a pixel, red, green, blue and alpha, rows from top to bottom.
    virtual void set_icon(std::span<const std::uint8_t> /*rgba*/, WindowSize /*size*/) {}
    /// Sets whether the mouse turns the view and cannot leave the window, or points at a menu. A change releases keys
    /// and buttons, so that presses in a menu do not reach the game.
    virtual void capture_mouse(bool /*is_captured*/) {}
    /// The name of an input on the player's own keyboard or gamepad, in printable ASCII; if unknown, name_of(). Empty
    /// if a touch screen is in use that has no button for it.
    virtual std::string local_name_of(Input input) const { return name_of(input); }
    /// Takes effect at the next picture. May be called each frame: without changes it costs nothing.
    virtual void change_window(const WindowSettings&) {}
    /// Waits for input that poll() would report, or for `timeout_ms`, without using the processor: for a game that is
    /// paused or minimised. False: there was no input, and the last picture is still shown. Without a window it returns
    /// at once.
    virtual bool wait_for_input(std::int32_t /*timeout_ms*/) { return true; }

    /// Shows the picture in the rectangle `shown` of the window, black around it. Waits for the display if possible.
    virtual void present(Framebuffer picture, const Palette& palette, const PresentRect& shown) = 0;
};

}  // namespace oblong
